// By how much two pieces must grow until their boundaries meet.
#pragma once

#include <optional>

#include "products/puzzle/pieces/puzzle_contact.h"

namespace tessera {

struct GrowthBetween {
  float distance = 0;  // by which each of the two grows; negative: it shrinks
  float rms = 0;       // distance of the boundaries when they have grown
};

/// For two pieces that lie about where they belong, in the unit of the pieces. Least squares over the pose and the distance
/// at once: a boundary that bends to all sides shows a gap all along, and no shift closes it. Along a straight line, which a shift
/// brings together as well, the distance says nothing. Nothing where hardly a boundary is near the other.
std::optional<GrowthBetween> growth_between(PosedPiece piece, const PosedPiece& neighbour, const PuzzleScale& scale);

}  // namespace tessera
