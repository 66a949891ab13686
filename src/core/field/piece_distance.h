// The distance to a placed piece.
#pragma once

#include "core/geometry/hull_distance.h"
#include "core/geometry/similarity.h"
#include "core/shape/shape.h"

namespace tessera {

/// Signed distance, px, from canvas positions (px) to a piece grown by `padding_px`; positive outside. Beyond the
/// shape's own grid it is a lower bound: the larger of the grid's and the hull's bound.
class PieceDistance {
 public:
  /// Keeps a reference to the shape.
  PieceDistance(const Shape& shape, const Similarity& canvas_from_shape, float padding_px)
      : field_(shape.field),
        shape_from_canvas_(canvas_from_shape.inverse()),
        scale_(canvas_from_shape.scale()),
        padding_px_(padding_px),
        hull_(shape.outline.curves.front()) {}

  float at(Vec2 canvas_px) const {
    const Vec2 p = shape_from_canvas_.apply(canvas_px);
    float beyond;
    const float nearest = field_.at_nearest(p, beyond);
    return scale_ * (beyond > 0 ? outside(p, nearest, beyond) : nearest) - padding_px_;
  }

  /// The largest difference between the distances at two positions `apart_px` apart. Bilinear look-up in exact
  /// distances has a slope of at most sqrt(2); the rest is for the rounding of the stored field and of the positions.
  static float most_change_px(float apart_px) { return 1.5f * apart_px + kRounding_px; }
  /// Number of successive nodes of a row that surely lie on the same side of a limit; `to_limit_px` is the first node's
  /// distance to it.
  static int nodes_on_same_side(float to_limit_px) {
    constexpr float kTwoNodes_px = 2 * 1.5f + kRounding_px;
    if (to_limit_px < kTwoNodes_px) return 1;  // a branch lets the next look-up start without waiting for this one
    return 1 + int((to_limit_px - kRounding_px) * (1 / 1.5f));
  }

 private:
  static constexpr float kRounding_px = 0.05f;

  float outside(Vec2 p, float nearest, float beyond) const {
    const float by_grid = std::sqrt(nearest * nearest + beyond * beyond);
    // At most the way via the nearest point of the grid, so that there is no jump at the grid's edge.
    return std::min(std::max(by_grid, hull_.at(p)), nearest + beyond);
  }

  const ShapeField& field_;
  Similarity shape_from_canvas_;
  float scale_;
  float padding_px_;
  HullDistance hull_;
};

}  // namespace tessera
