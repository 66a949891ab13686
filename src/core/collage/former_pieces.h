// Pieces that were taken out of a collage, so that others come in for them: what fits a hole best is what lay in it.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/period.h"
#include "core/geometry/similarity.h"
#include "core/settings/settings.h"
#include "core/shape/shape_id.h"

namespace tessera {

/// Whether a piece at `now` lies where one of the same drawing lay at `then`: its centre is nearer to the other's than
/// half of that one's size.
bool lies_where_it_lay(const Similarity& then, const Similarity& now, const Period& period);

struct TakenOut {
  ShapeId shape{};
  std::uint32_t region = 0;  // in which it lay
};

/// Says for each of `pieces` whether a shape of another silhouette may come in for it, by weights, regions and uses,
/// beside the given pieces of the settings. False also where the piece's own least uses want it again, as all others
/// wait then. `silhouettes`, `drawings`: for each shape of the library the first one that looks like it, and the one
/// that it is the mirror image of.
std::vector<bool> others_may_come_in(const std::vector<TakenOut>& pieces, const CollageSettings& settings,
                                     const std::vector<std::uint32_t>& silhouettes,
                                     const std::vector<std::uint32_t>& drawings);

}  // namespace tessera
