// Finds by how much two pieces must grow until their boundaries meet.
#pragma once

#include <optional>

#include "products/puzzle/pieces/puzzle_contact.h"

namespace tessera {

struct GrowthBetween {
  float distance = 0;  // distance by which each of the two grows; negative: it shrinks
  float rms = 0;       // distance of the boundaries after that
};

/// Computes the growth of two pieces that lie about where they belong, in the unit of the pieces. Least squares over the
/// pose and the distance at once: a boundary that bends in all directions shows a gap all along, which no shift closes.
/// Along a straight line a shift closes the gap as well, so that the distance there means nothing. Empty where hardly any
/// of the boundaries are near each other.
std::optional<GrowthBetween> growth_between(PosedPiece piece, const PosedPiece& neighbour, const PuzzleScale& scale);

}  // namespace tessera
