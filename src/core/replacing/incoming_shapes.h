// Selects the shapes that may come into a replacement window.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/period.h"
#include "core/geometry/polygon.h"
#include "core/matching/stances.h"
#include "core/replacing/replacement.h"
#include "core/settings/wishes.h"
#include "core/shape/shape_source.h"

namespace tessera {

/// The shapes that may stand, with all their stances. Of a large library only as many as a rank can test, drawn by
/// `random`. Weights are relative to the largest weight.
std::vector<IncomingShape> incoming_shapes(const StanceTable& stances, const ShapeSource& shapes, std::uint64_t random);

/// The shapes of `incoming` that may come into the window `box`. A shape stays out if a piece of its drawing was taken
/// out in this window and must not come back (`not_back`). The whole window counts, as the place of a new piece is not
/// known before. If fewer than half would remain, all may come in.
std::vector<IncomingShape> shapes_for_window(const Box& box, const std::vector<IncomingShape>& incoming,
                                             const std::vector<FormerPiece>& not_back, const Period& period,
                                             const ShapeSource& shapes);

}  // namespace tessera
