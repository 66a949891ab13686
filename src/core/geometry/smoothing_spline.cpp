#include "core/geometry/smoothing_spline.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/geometry/closed_curve.h"

namespace tessera {
namespace {

constexpr int kLengthSteps = 4;  // chords per span; their sum is short by less than 1e-4 on a silhouette's bends
constexpr double kHalfHeight = 1.17741;  // a Gaussian of width 1 passes half of a ripple of this angular frequency
constexpr int kLeastKnots = 16;

/// Weights of the four control points around a span at its parameter u in [0, 1], for a derivative of the given order.
std::array<double, 4> basis(double u, int derivative) {
  const double v = 1 - u;
  switch (derivative) {
    case 0:
      return {v * v * v / 6, (3 * u * u * u - 6 * u * u + 4) / 6, (3 * v * v * v - 6 * v * v + 4) / 6, u * u * u / 6};
    case 1: return {-v * v / 2, (3 * u * u - 4 * u) / 2, -(3 * v * v - 4 * v) / 2, u * u / 2};
    default: return {v, 3 * u - 2, 3 * v - 2, u};
  }
}

/// B + lambda·D² of n cyclic knots: B takes control points to knots (1 4 1)/6, D² is the fourth difference. This is the
/// normal equation of the smoothing spline, divided by a factor B; it is positive definite.
Eigen::SparseMatrix<double> normal_matrix(int n, double lambda) {
  const std::array<double, 3> diagonal = {4.0 / 6 + 6 * lambda, 1.0 / 6 - 4 * lambda, lambda};
  std::vector<Eigen::Triplet<double>> entries;
  for (int row = 0; row < n; ++row) {
    for (int k = -2; k <= 2; ++k) entries.emplace_back(row, (row + k + n) % n, diagonal[std::abs(k)]);
  }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

ClosedSpline::ClosedSpline(Eigen::Matrix2Xd control) : control_(std::move(control)) {
  const int steps = spans() * kLengthSteps;
  length_until_.reserve(steps + 1);
  length_until_.push_back(0);
  Vec2 from = position(0);
  for (int i = 1; i <= steps; ++i) {
    const Vec2 to = position(double(i) / kLengthSteps);
    length_until_.push_back(length_until_.back() + norm(to - from));
    from = to;
  }
}

Vec2 ClosedSpline::combine(double t, int derivative) const {
  const int n = spans();
  const double whole = std::floor(t);
  const int span = (int(whole) % n + n) % n;
  const std::array<double, 4> weight = basis(t - whole, derivative);
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int k = 0; k < 4; ++k) sum += weight[k] * control_.col((span + k + n - 1) % n);
  return {float(sum.x()), float(sum.y())};
}

double ClosedSpline::curvature(double t) const {
  const Vec2 d = first_derivative(t);
  const double speed = norm(d);
  return speed > 0 ? cross(d, second_derivative(t)) / (speed * speed * speed) : 0;
}

std::vector<Vec2> ClosedSpline::even_points(int count) const {
  std::vector<Vec2> points;
  points.reserve(count);
  std::size_t cursor = 0;
  for (int i = 0; i < count; ++i) points.push_back(position(parameter_at(length() * i / count, cursor)));
  return points;
}

/// `cursor` is the table entry at which the search begins: lengths are asked in ascending order.
double ClosedSpline::parameter_at(double length, std::size_t& cursor) const {
  while (cursor + 2 < length_until_.size() && length_until_[cursor + 1] < length) ++cursor;
  const double step = length_until_[cursor + 1] - length_until_[cursor];
  const double within = step > 0 ? (length - length_until_[cursor]) / step : 0;
  return (double(cursor) + within) / kLengthSteps;
}

ClosedSpline smoothing_spline(const std::vector<Vec2>& polygon, double sigma) {
  const double length = closed_length(polygon);
  const int n = std::max(kLeastKnots, int(length / std::min(sigma, 1.0)));
  const std::vector<Vec2> even = resampled_closed(polygon, n);

  Eigen::MatrixX2d target(n, 2);
  for (int i = 0; i < n; ++i) target.row(i) << even[i].x, even[i].y;
  // Half of a ripple passes where lambda · omega^4 = 1, omega in radians per knot.
  const double lambda = std::pow(sigma * n / length / kHalfHeight, 4);
  // In natural order only the two rows that close the cycle fill in, so time and memory are proportional to n.
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>> solver(
      normal_matrix(n, lambda));
  const Eigen::MatrixX2d control = solver.solve(target);
  return ClosedSpline(control.transpose());
}

}  // namespace tessera
