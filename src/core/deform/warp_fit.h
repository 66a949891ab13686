// From where the points of an outline are to go to a warp of all that it encloses: as near to that as it can be while it
// stays smooth. Least squares of what is missing at the outline's points and of the strain of the whole grid, a membrane.
#pragma once

#include <Eigen/SparseCholesky>
#include <array>
#include <vector>

#include "core/deform/warp.h"
#include "core/shape/shape.h"

namespace tessera {

struct WarpFitSettings {
  float step = 0.03f;        // of the grid, shape units
  float stiffness = 0.003f;  // shape units: what is shorter along the outline is smoothed away
};

/// For one shape, which has outline and field; for any number of wishes.
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
    float length = 0;  // of the outline that it stands for
  };

  void lay_grid(const Shape& shape, float step);
  void number_nodes();
  void set_points(const Outline& outline);
  void set_system(float stiffness);

  Warp grid_;             // without displacements
  Grid<int> unknown_of_;  // of each node; -1: it belongs to no active cell
  int unknowns_ = 0;
  std::vector<Point> points_;
  bool solvable_ = false;  // else nothing moves
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> system_;
};

}  // namespace tessera
