// The edge of the canvas as pieces feel it: also far outside, where the canvas' field ends.
#pragma once

#include "core/field/free_field.h"

namespace tessera {

class CanvasEdge {
 public:
  /// Of the canvas of this field, whatever lies in it. It outlives the edge.
  explicit CanvasEdge(const FreeField& free) : free_(free) {}

  const Period& period() const { return free_.grid().period(); }

  /// FreeField::canvas_sample(). Beyond the field's nodes: the value at the nearest one, less the way there.
  FieldSample at(Vec2 canvas_px) const;

 private:
  const FreeField& free_;
};

}  // namespace tessera
