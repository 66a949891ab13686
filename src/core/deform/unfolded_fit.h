// Warps of a piece without folds: the wished movement of the boundary is smoothed until the drawing can follow.
#pragma once

#include <memory>
#include <vector>

#include "core/deform/warp_fit.h"
#include "core/shape/shape.h"

namespace tessera {

/// Least allowed ratio of areas after and before, for every part of a drawing.
inline constexpr float kLeastJacobian = 0.25f;

/// Waves along the boundary up to a few times this length are smoothed away: shorter ones are noise of gaps.
inline constexpr float kWishStiffness_px = 2;
/// The stiffness for a boundary that a warp has already made.
inline constexpr float kMadeStiffness_px = 0.02f;

class UnfoldedFit {
 public:
  /// `shape` has outline and field, and must outlive this object. `scale_px`: scale of the piece.
  UnfoldedFit(const Shape& shape, float scale_px, float stiffness_px = kWishStiffness_px);

  /// The warp for these displacements of the outline's points, curve after curve, shape units. Its least_jacobian() is
  /// at least kLeastJacobian. If the displacements would give less, this fit smooths more from now on.
  Warp warp(const std::vector<Vec2>& displacements);

 private:
  void lay();

  const Shape& shape_;
  const float scale_px_;
  const float stiffness_px_;
  int stiffer_ = 0;  // number of times that the stiffness was increased
  std::unique_ptr<WarpFit> fit_;
};

}  // namespace tessera
