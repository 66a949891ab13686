// The result of a collage: the shapes and their poses.
#pragma once

#include "core/geometry/similarity.h"
#include "core/shape/shape_id.h"

namespace tessera {

/// A candidate that was chosen. Canvas frame: px, y down, origin at the canvas' upper left corner.
struct Placement {
  ShapeId shape{};
  Similarity canvas_from_shape;
  float score = 0;
  float matched_px = 0;  // when placed: length of its boundary within match.delta_px of the free region's boundary

  friend bool operator==(const Placement&, const Placement&) = default;
};

}  // namespace tessera
