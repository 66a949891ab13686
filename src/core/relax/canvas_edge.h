// The edge of the canvas, or of one of its regions, as pieces feel it: also far outside, where the canvas' field ends.
#pragma once

#include "core/field/canvas.h"
#include "core/field/field_lookup.h"

namespace tessera {

class CanvasEdge {
 public:
  /// The canvas outlives it.
  explicit CanvasEdge(const Canvas& canvas) : canvas_(canvas) {}

  const Period& period() const { return canvas_.period; }

  /// Canvas::distance with its gradient. Beyond the field's nodes: the value at the nearest one, less the way there.
  FieldSample at(Vec2 canvas_px) const;

 private:
  const Canvas& canvas_;
};

}  // namespace tessera
