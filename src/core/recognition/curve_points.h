// The points of some curves in one list, as they are laid onto a query.
#pragma once

#include <span>
#include <vector>

#include "core/recognition/boundary_fit.h"
#include "core/recognition/curve.h"

namespace tessera {

class CurvePoints {
 public:
  /// `curves`: of evenly spaced points, as far apart in all of them.
  explicit CurvePoints(std::span<const Curve> curves);

  /// Adds each point once more with the opposite direction: of two lines without an interior, neither says in which
  /// direction it was drawn. One of both follows a query's curve at most.
  void add_opposite();

  BoundaryPoints boundary() const { return {position_, tangent_, spacing_}; }

 private:
  std::vector<Vec2> position_;
  std::vector<Vec2> tangent_;
  float spacing_ = 0;
};

}  // namespace tessera
