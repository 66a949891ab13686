// A piece of any collage, given by its outline on the canvas: the unit of all quality measures.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/collage/placement.h"
#include "core/shape/shape.h"
#include "core/style/style_features.h"

namespace tessera {

struct JudgedPiece {
  Outline outline_px;   // canvas frame; at least one point. Even-odd rule: several outer curves are one piece
  std::string shape;    // pieces with the same name show one shape or its mirror image; empty: the shape is unknown
  Vec2 centre_px;       // centroid of its area
  double scale_px = 0;  // square root of its area, above 0
  StyleFeatures style = {};  // of its shape
};

/// The pieces of a collage. `shape(i)` gives library shape i with its outline.
std::vector<JudgedPiece> judged_pieces(const std::vector<Placement>& placements,
                                       const std::function<const Shape&(ShapeId)>& shape);

}  // namespace tessera
