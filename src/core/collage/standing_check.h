// Checks whether the poses of given pieces are good. It reports faults and corrects nothing.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "core/field/canvas.h"
#include "core/settings/wishes.h"
#include "core/shape/shape.h"

namespace tessera {

/// Indices in the list of pieces, ascending. A piece may be in several lists.
struct GivenPieceCheck {
  std::vector<std::size_t> outside;      // part of the area is outside the canvas
  std::vector<std::size_t> kept_out;     // part of the area is in a zone that pieces keep out of
  std::vector<std::size_t> overlapping;  // part of the area is on pieces before it
};

/// Checks the pieces on cells of 1 px. `shape(id)` gives library shapes with their outlines. Two areas are tolerated.
/// One is the fraction of a piece's area that a run itself leaves where pieces touch. The other is a strip `overlap_px`
/// deep along half of the outline (PieceSettings::overlap_px; 0 with padding).
GivenPieceCheck check_given_pieces(const Canvas& canvas, const std::vector<GivenPiece>& pieces, float overlap_px,
                                   const std::function<const Shape&(ShapeId)>& shape);

}  // namespace tessera
