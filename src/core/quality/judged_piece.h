// A piece as it lies on the canvas, whoever laid it there: what a collage is judged by.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/collage/placement.h"
#include "core/shape/shape.h"
#include "core/style/style_features.h"

namespace tessera {

struct JudgedPiece {
  Outline outline_px;   // canvas frame; has a point at least. By the even-odd rule: several outer curves are one piece
  std::string shape;    // pieces of one name show one shape, or its mirror image; empty: nobody says which
  Vec2 centre_px;       // of its area
  double scale_px = 0;  // square root of its area, above 0
  StyleFeatures style = {};  // of its shape
};

/// Of a collage. `shape(i)` gives library shape i with its outline.
std::vector<JudgedPiece> judged_pieces(const std::vector<Placement>& placements,
                                       const std::function<const Shape&(ShapeId)>& shape);

}  // namespace tessera
