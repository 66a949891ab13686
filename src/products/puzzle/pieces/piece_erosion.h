// Pieces that were sawn or scanned are a little smaller all round than what they were cut from. Grown by as much they
// fit.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/base/stop.h"
#include "core/geometry/vec2.h"
#include "products/puzzle/pieces/puzzle_piece.h"

namespace tessera {

/// The polygon (interior on its left) with its boundary moved outward by a distance that is small beside its parts.
std::vector<Vec2> grown_polygon(const std::vector<Vec2>& polygon, float distance);

/// The distance by which pieces must grow so that their boundaries run alike the farthest, in their unit, and meet; 0 where
/// they fit as they are. Nothing where boundaries do not tell, as those of polygons: grown a little more or less, a straight
/// side is as long as some other one. `check_stop` is called often; what it throws ends the search.
std::optional<float> erosion_of(const std::vector<std::vector<Vec2>>& pieces, const PuzzleScale& scale,
                                const StopCheck& check_stop);

/// Distances to be tried in this order until the pieces fit: the one that boundaries tell, or else first the one by
/// which pieces fill the frame, then none, then such as are usual. `frame_area`: of a frame that is known to be as
/// large as that, in the pieces' unit; 0: there is none.
std::vector<float> likely_erosions(const std::vector<std::vector<Vec2>>& pieces, double frame_area,
                                   const PuzzleScale& scale, const StopCheck& check_stop);

}  // namespace tessera
