// Whether pieces that somebody put where they stand lie well: told, not corrected.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "core/field/canvas.h"
#include "core/settings/wishes.h"
#include "core/shape/shape.h"

namespace tessera {

/// Places in the list of pieces, ascending. A piece may be in several lists.
struct StandingCheck {
  std::vector<std::size_t> outside;      // with some of their area outside the canvas
  std::vector<std::size_t> kept_out;     // with some of it in a zone that pieces keep out of
  std::vector<std::size_t> overlapping;  // with some of it on pieces before them
};

/// `shape(id)` gives library shapes with their outlines. Counted on cells of 1 px; as little of a piece's area as where
/// a run itself makes pieces touch does not count, nor what a piece may have in others and beyond the edge along half of
/// its outline, `overlap_px` deep (PieceSettings::overlap_px; 0 with padding).
StandingCheck check_standing(const Canvas& canvas, const std::vector<GivenPiece>& pieces, float overlap_px,
                             const std::function<const Shape&(ShapeId)>& shape);

}  // namespace tessera
