#include "products/puzzle/pieces/growth_between.h"

#include <Eigen/Dense>
#include <cmath>
#include <vector>

namespace tessera {
namespace {

/// Gauss-Newton steps.
constexpr int kGrowthSteps = 5;
/// In tolerances: boundaries that are farther apart belong to other sides.
constexpr float kGrowthReach = 2;
/// The least number of points, those of a short side; fewer tell nothing.
constexpr std::size_t kLeastPoints = 24;
/// Keeps unknowns at 0 that the points do not determine.
constexpr double kDamping = 0.5;

/// One point of the boundary: its distance from the other boundary along the normal, and how that changes with the two
/// shifts, the turn and the growth.
struct Row {
  Eigen::Vector4d by;
  double apart;
};

std::vector<Row> rows_of(const PosedPiece& piece, const PosedPiece& neighbour, const PuzzleScale& scale, double arm) {
  const float reach = kGrowthReach * scale.tolerance;
  const Similarity there_from_puzzle = rigid_inverse(neighbour.pose);
  const Vec2 centre = piece.pose.apply(piece.piece->centre);
  std::vector<Row> rows;
  for (std::size_t k = 0; k < piece.piece->points.size(); ++k) {
    const Vec2 p = piece.pose.apply(piece.piece->points[k]);
    const Approach near = neighbour.piece->outline.approach(there_from_puzzle.apply(p), reach);
    if (near.distance >= reach) continue;
    const Vec2 along = piece.pose.apply_direction(piece.piece->directions[k]), normal{along.y, -along.x};
    rows.push_back({{normal.x, normal.y, cross(p - centre, normal) / arm, 1},
                    double(dot(p - neighbour.pose.apply(near.there), normal))});
  }
  return rows;
}

}  // namespace

std::optional<GrowthBetween> growth_between(PosedPiece piece, const PosedPiece& neighbour, const PuzzleScale& scale) {
  const double arm = scale.piece / 2;  // turns angles into lengths
  GrowthBetween found;
  for (int step = 0; step < kGrowthSteps; ++step) {
    const std::vector<Row> rows = rows_of(piece, neighbour, scale, arm);
    if (rows.size() < kLeastPoints) return {};
    Eigen::Matrix4d hessian = Eigen::Matrix4d::Identity() * kDamping;
    Eigen::Vector4d gradient = Eigen::Vector4d::Zero();
    for (const Row& row : rows) {
      hessian += row.by * row.by.transpose();
      gradient += row.by * row.apart;
    }
    const Eigen::Vector4d move = hessian.ldlt().solve(-gradient);
    double squares = 0;
    for (const Row& row : rows) squares += std::pow(row.apart + row.by.dot(move), 2);
    found = {float(move[3] / 2), float(std::sqrt(squares / double(rows.size())))};
    piece.pose = moved(piece, {float(move[0]), float(move[1])}, move[2] / arm);
  }
  return found;
}

}  // namespace tessera
