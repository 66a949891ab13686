// Fits a smooth warp of a shape's whole area to the wished displacements of its outline's points. Least squares of the
// errors at these points and of the strain of the whole grid, a membrane.
#pragma once

#include <Eigen/SparseCholesky>
#include <array>
#include <vector>

#include "core/deform/warp.h"
#include "core/shape/shape.h"

namespace tessera {

struct WarpFitSettings {
  float step = 0.03f;        // of the grid, shape units
  float stiffness = 0.003f;  // shape units: waves shorter than this along the outline are smoothed away
};

/// The fit for one shape, which has outline and field; for any number of displacements.
class WarpFit {
 public:
  WarpFit(const Shape& shape, const WarpFitSettings& settings);

  /// `displacements`: of the outline's points, curve after curve, shape units.
  Warp fitted(const std::vector<Vec2>& displacements) const;

 private:
  /// An outline point between three nodes.
  struct Point {
    std::array<int, 3> unknown{};
    std::array<float, 3> weight{};
    float length = 0;  // length of the outline that the point stands for
  };

  void lay_grid(const Shape& shape, float step);
  void number_nodes();
  void set_points(const Outline& outline);
  void set_system(float stiffness);

  Warp grid_;             // without displacements
  Grid<int> unknown_of_;  // unknown of each node; -1: it belongs to no active cell
  int unknowns_ = 0;
  std::vector<Point> points_;
  bool solvable_ = false;  // false: nothing moves
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> system_;
};

}  // namespace tessera
