// Which pieces are missing in a finished collage: of each shape as many must stand as the job or a wish says at least.
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

/// The shapes that may stand in some region of the canvas and stand too rarely, ascending. `drawings`: for each shape of
/// the library the one that it is the mirror image of, mostly itself: a piece of either counts for that one.
std::vector<MissingPieces> missing_pieces(const CollageSettings& settings, const std::vector<std::uint32_t>& drawings,
                                          const std::vector<Placement>& placements);

/// How many pieces there may be of all shapes that may stand in some region; infinity where one may stand as often as
/// there is room. A drawing and its mirror image count once.
double most_pieces(const CollageSettings& settings, const std::vector<std::uint32_t>& drawings);

}  // namespace tessera
