// Pieces that were sawn or scanned are a little smaller all round than what they were cut from. Grown by as much they
// fit.
#pragma once

#include <functional>
#include <vector>

#include "core/geometry/vec2.h"
#include "core/puzzle/puzzle_piece.h"

namespace tessera {

/// The polygon (interior on its left) with its boundary moved outward by a distance that is small beside its parts.
std::vector<Vec2> grown_polygon(const std::vector<Vec2>& polygon, float distance);

/// The distance by which pieces must grow so that their boundaries run alike the farthest, in their unit; 0 where they
/// fit as they are, or not at all. `watch` is called often; what it throws ends the search.
float erosion_of(const std::vector<std::vector<Vec2>>& pieces, const PuzzleScale& scale,
                 const std::function<void()>& watch);

}  // namespace tessera
