#include "core/deform/warp_fit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/geometry/polygon.h"

namespace tessera {
namespace {

/// Cells around the outline that are active, too: smoothed curves and antialiased edges lie slightly beyond it.
constexpr int kMarginCells = 2;
/// Largest number of nodes of a grid: ten times that of a shape with usual proportions. Longer shapes get wider cells.
constexpr float kMostNodes = 1 << 16;
/// Added on the diagonal: holds nodes that no point of the outline reaches.
constexpr double kHold = 1e-9;

/// Calls f(point, length of the outline that it stands for).
template <class F>
void each_point(const Outline& outline, F f) {
  for (const std::vector<Vec2>& curve : outline.curves) {
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const Vec2 before = curve[i == 0 ? curve.size() - 1 : i - 1];
      const Vec2 after = curve[i + 1 == curve.size() ? 0 : i + 1];
      f(curve[i], 0.5f * (norm(curve[i] - before) + norm(after - curve[i])));
    }
  }
}

}  // namespace

WarpFit::WarpFit(const Shape& shape, const WarpFitSettings& settings) {
  lay_grid(shape, settings.step);
  number_nodes();
  set_points(shape.outline);
  set_system(settings.stiffness);
}

/// Sets the grid. Cells in the shape or near its outline are active.
void WarpFit::lay_grid(const Shape& shape, float step) {
  const Box box = bounding_box(shape.outline);
  step =
      std::max({step, std::sqrt(box.width() * box.height() / kMostNodes), (box.width() + box.height()) / kMostNodes});
  const float margin = float(kMarginCells) * step;
  const int columns = int(std::ceil((box.width() + 2 * margin) / step)) + 1;
  const int rows = int(std::ceil((box.height() + 2 * margin) / step)) + 1;
  grid_.origin = box.low - Vec2{margin, margin};
  grid_.step = step;
  grid_.displacement = Grid<Vec2>(columns, rows);
  grid_.active = Grid<std::uint8_t>(columns - 1, rows - 1, 0);
  for (int j = 0; j + 1 < rows; ++j) {
    for (int i = 0; i + 1 < columns; ++i) {
      grid_.active(i, j) = shape.field.at(grid_.node(i, j) + Vec2{0.5f * step, 0.5f * step}) < margin;
    }
  }
  each_point(shape.outline, [&](Vec2 p, float) {  // parts that are too thin for the field, too
    const Vec2 at = (p - grid_.origin) * (1 / step);
    grid_.active(std::clamp(int(at.x), 0, columns - 2), std::clamp(int(at.y), 0, rows - 2)) = 1;
  });
}

void WarpFit::number_nodes() {
  unknown_of_ = Grid<int>(grid_.displacement.width(), grid_.displacement.height(), -1);
  for (int j = 0; j < grid_.active.height(); ++j) {
    for (int i = 0; i < grid_.active.width(); ++i) {
      if (!grid_.active(i, j)) continue;
      for (const auto& [x, y] : {std::pair{i, j}, {i + 1, j}, {i, j + 1}, {i + 1, j + 1}}) {
        if (unknown_of_(x, y) < 0) unknown_of_(x, y) = unknowns_++;
      }
    }
  }
}

void WarpFit::set_points(const Outline& outline) {
  each_point(outline, [&](Vec2 p, float length) {
    const WarpWeights at = grid_.weights_at(p);
    Point point{.weight = at.weight, .length = length};
    for (int k = 0; k < 3; ++k) point.unknown[k] = std::max(0, unknown_of_(at.x[k], at.y[k]));
    points_.push_back(point);
  });
}

void WarpFit::set_system(float stiffness) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < unknowns_; ++i) entries.emplace_back(i, i, kHold);
  const auto tie = [&](int x0, int y0, int x1, int y1) {
    const int a = unknown_of_(x0, y0), b = unknown_of_(x1, y1);
    if (a < 0 || b < 0) return;
    entries.emplace_back(a, a, stiffness);
    entries.emplace_back(b, b, stiffness);
    entries.emplace_back(a, b, -stiffness);
    entries.emplace_back(b, a, -stiffness);
  };
  for (int j = 0; j < unknown_of_.height(); ++j) {
    for (int i = 0; i < unknown_of_.width(); ++i) {
      if (i + 1 < unknown_of_.width()) tie(i, j, i + 1, j);
      if (j + 1 < unknown_of_.height()) tie(i, j, i, j + 1);
    }
  }
  for (const Point& point : points_) {
    for (int k = 0; k < 3; ++k) {
      for (int l = 0; l < 3; ++l) {
        entries.emplace_back(point.unknown[k], point.unknown[l],
                             double(point.length) * double(point.weight[k]) * double(point.weight[l]));
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(unknowns_, unknowns_);
  matrix.setFromTriplets(entries.begin(), entries.end());
  system_.compute(matrix);
  solvable_ = system_.info() == Eigen::Success;
}

Warp WarpFit::fitted(const std::vector<Vec2>& displacements) const {
  if (!solvable_) return grid_;
  Eigen::MatrixX2d wished = Eigen::MatrixX2d::Zero(unknowns_, 2);
  for (std::size_t p = 0; p < points_.size(); ++p) {
    for (int k = 0; k < 3; ++k) {
      const double weight = double(points_[p].length) * double(points_[p].weight[k]);
      wished(points_[p].unknown[k], 0) += weight * double(displacements[p].x);
      wished(points_[p].unknown[k], 1) += weight * double(displacements[p].y);
    }
  }
  const Eigen::MatrixX2d found = system_.solve(wished);
  Warp warp = grid_;
  for (int j = 0; j < unknown_of_.height(); ++j) {
    for (int i = 0; i < unknown_of_.width(); ++i) {
      const int unknown = unknown_of_(i, j);
      if (unknown >= 0) warp.displacement(i, j) = {float(found(unknown, 0)), float(found(unknown, 1))};
    }
  }
  return warp;
}

}  // namespace tessera
