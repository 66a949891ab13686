// Warps of a piece that fold nothing: what a boundary wishes is smoothed until its drawing can follow.
#pragma once

#include <memory>
#include <vector>

#include "core/deform/warp_fit.h"
#include "core/shape/shape.h"

namespace tessera {

/// No part of a drawing is compressed to less of its area.
inline constexpr float kLeastJacobian = 0.25f;

/// Waves along the boundary of some times this length are smoothed away: what is found there otherwise is noise of gaps.
inline constexpr float kWishStiffness_px = 2;
/// Of a boundary that a warp has made already.
inline constexpr float kMadeStiffness_px = 0.02f;

class UnfoldedFit {
 public:
  /// `shape` has outline and field, and must outlive it. `scale_px`: of the piece.
  UnfoldedFit(const Shape& shape, float scale_px, float stiffness_px = kWishStiffness_px);

  /// `displacements`: of the outline's points, curve after curve, shape units. The warp's least_jacobian() is kLeastJacobian or
  /// more; what asked for more than that is smoothed from now on.
  Warp warp(const std::vector<Vec2>& displacements);

 private:
  void lay();

  const Shape& shape_;
  const float scale_px_;
  const float stiffness_px_;
  int stiffer_ = 0;  // so many times
  std::unique_ptr<WarpFit> fit_;
};

}  // namespace tessera
