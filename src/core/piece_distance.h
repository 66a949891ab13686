// The distance to a piece as it lies on the canvas.
#pragma once

#include "core/shape.h"
#include "core/similarity.h"

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
  /// Positions nearer than this differ by less than `change_px`; negative where none is sure to.
  static float sure_reach_px(float change_px) { return (change_px - kRounding_px) * (1 / 1.5f); }

 private:
  static constexpr float kRounding_px = 0.05f;

  const ShapeField& field_;
  Similarity shape_from_canvas_;
  float scale_;
  float padding_px_;
};

}  // namespace tessera
