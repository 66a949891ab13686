// The points of several curves in one list, for poses on a query.
#pragma once

#include <span>
#include <vector>

#include "core/recognition/boundary_fit.h"
#include "core/recognition/curve.h"

namespace tessera {

class CurvePoints {
 public:
  /// `curves`: evenly spaced points with the same spacing in all curves.
  explicit CurvePoints(std::span<const Curve> curves);

  /// Adds each point a second time with the opposite direction, as a line without an interior does not tell in which
  /// direction it was drawn. At most one of the two follows a query's curve.
  void add_opposite();

  BoundaryPoints boundary() const { return {position_, tangent_, spacing_}; }

 private:
  std::vector<Vec2> position_;
  std::vector<Vec2> tangent_;
  float spacing_ = 0;
};

}  // namespace tessera
