// Pieces that were sawn or scanned are a little smaller all around than they were cut. They fit when they are grown again.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/base/stop.h"
#include "core/geometry/vec2.h"
#include "products/puzzle/pieces/puzzle_piece.h"

namespace tessera {

/// The polygon (interior on its left) with its boundary moved outward by a distance that is small compared with its parts.
std::vector<Vec2> grown_polygon(const std::vector<Vec2>& polygon, float distance);

/// The distance by which pieces must grow, in their unit, so that their boundaries meet and agree over the longest parts; 0
/// where they fit already. Empty where boundaries do not tell, as with polygons: a straight side, grown a little more or
/// less, is as long as some other one. `check_stop` is called often; what it throws ends the search.
std::optional<float> erosion_of(const std::vector<std::vector<Vec2>>& pieces, const PuzzleScale& scale,
                                const StopCheck& check_stop);

/// Distances to try, in this order, until the pieces fit: the one that boundaries tell, or else the one by which pieces
/// fill the frame, then 0, then usual distances. `frame_area`: of a frame that is known to have exactly this size, in the
/// pieces' unit; 0: there is none.
std::vector<float> likely_erosions(const std::vector<std::vector<Vec2>>& pieces, double frame_area,
                                   const PuzzleScale& scale, const StopCheck& check_stop);

}  // namespace tessera
