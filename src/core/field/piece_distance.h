// The distance to a piece as it lies on the canvas.
#pragma once

#include "core/geometry/similarity.h"
#include "core/shape/shape.h"

namespace tessera {

/// Signed distance, px, from canvas positions (px) to a piece grown by `padding_px`; positive outside.
class PieceDistance {
 public:
  /// Keeps a reference to the shape.
  PieceDistance(const Shape& shape, const Similarity& canvas_from_shape, float padding_px)
      : field_(shape.field),
        shape_from_canvas_(canvas_from_shape.inverse()),
        scale_(canvas_from_shape.scale()),
        padding_px_(padding_px) {}

  float at(Vec2 canvas_px) const { return scale_ * field_.at(shape_from_canvas_.apply(canvas_px)) - padding_px_; }

  /// The most by which positions `apart_px` apart differ: bilinear look-up in exact distances is at most sqrt(2) steep,
  /// the rest is for the rounding of the stored field and of the positions.
  static float most_change_px(float apart_px) { return 1.5f * apart_px + kRounding_px; }
  /// How many positions of a row of nodes, from one that is `to_limit_px` from a limit on, are on the same side of it.
  static int nodes_on_same_side(float to_limit_px) {
    constexpr float kTwoNodes_px = 2 * 1.5f + kRounding_px;
    if (to_limit_px < kTwoNodes_px) return 1;  // a branch: where it holds, the next look-up need not wait for this one
    return 1 + int((to_limit_px - kRounding_px) * (1 / 1.5f));
  }

 private:
  static constexpr float kRounding_px = 0.05f;

  const ShapeField& field_;
  Similarity shape_from_canvas_;
  float scale_;
  float padding_px_;
};

}  // namespace tessera
