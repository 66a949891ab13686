// The distance to the canvas' edge for relaxation; it is also defined far outside, where the canvas' field ends.
#pragma once

#include "core/field/free_field.h"

namespace tessera {

class EdgeDistance {
 public:
  /// The edge of the canvas of `free`, without its pieces. `free` must outlive this object.
  explicit EdgeDistance(const FreeField& free)
      : field_(free.canvas_view()),
        period_(free.grid().period()),
        add_px_(free.padding_px()) {}
  /// The edge of a canvas that does not repeat: `distance` to it in px, positive inside, at nodes `node_px` apart. The
  /// field must outlive this object.
  EdgeDistance(const CanvasField& distance, float node_px) : field_(distance), node_px_(node_px) {}

  const Period& period() const { return period_; }
  /// The distance of two nodes.
  float node_px() const { return node_px_; }

  /// Distance to the edge, positive inside, with its gradient. Beyond the field's nodes: the value at the nearest one,
  /// less the way there.
  FieldSample at(Vec2 canvas_px) const;

 private:
  FieldView field_;
  Period period_;
  float add_px_ = 0;
  float node_px_ = 1;
};

}  // namespace tessera
