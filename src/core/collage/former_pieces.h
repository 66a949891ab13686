// Pieces that were taken out of a collage to be replaced by others. The piece that fits a hole best is the one that lay
// in it, so these rules keep it from coming back.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/period.h"
#include "core/geometry/similarity.h"
#include "core/settings/settings.h"
#include "core/shape/shape_id.h"

namespace tessera {

/// Whether a piece at `now` lies where a piece of the same drawing lay at `then`. It does if the distance of their
/// centres is less than half of the former piece's size.
bool is_at_former_place(const Similarity& then, const Similarity& now, const Period& period);

struct TakenOut {
  ShapeId shape{};
  std::uint32_t region = 0;  // in which the piece lay
};

/// Tells for each of `pieces` whether a shape of another silhouette may replace it. Weights, regions, uses and the
/// given pieces of the settings decide. False also if the piece's own least uses want its shape again, as all other
/// shapes wait then. `silhouettes`, `drawings`: for each shape of the library the first shape that looks like it, and
/// the shape whose mirror image it is.
std::vector<bool> may_be_replaced(const std::vector<TakenOut>& pieces, const CollageSettings& settings,
                                  const std::vector<std::uint32_t>& silhouettes,
                                  const std::vector<std::uint32_t>& drawings);

}  // namespace tessera
