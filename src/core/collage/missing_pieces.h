// Pieces that are missing in a finished collage: the job or a wish says how many pieces of each shape must stand at
// least.
#pragma once

#include <cstdint>
#include <vector>

#include "core/collage/placement.h"
#include "core/settings/settings.h"
#include "core/shape/shape_id.h"

namespace tessera {

struct MissingPieces {
  ShapeId shape{};
  int wanted = 0;    // at least
  int standing = 0;  // fewer
};

/// The shapes that may stand in some region of the canvas and stand too rarely, ascending. `drawings`: for each shape
/// of the library the shape whose mirror image it is, or itself; a piece of either counts for that shape.
std::vector<MissingPieces> missing_pieces(const CollageSettings& settings, const std::vector<std::uint32_t>& drawings,
                                          const std::vector<Placement>& placements);

/// The largest number of pieces of all shapes that may stand in some region; infinity if one of them has no limit. A
/// drawing and its mirror image count once.
double most_pieces(const CollageSettings& settings, const std::vector<std::uint32_t>& drawings);

}  // namespace tessera
