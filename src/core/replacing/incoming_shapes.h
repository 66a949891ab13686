// Which shapes may come into a replacement window.
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

/// The shapes that may stand, with all their stances: all of a small library, and as many of a large one as a rank can
/// look at, drawn by `random`. Weights are relative to the largest weight.
std::vector<IncomingShape> incoming_shapes(const StanceTable& stances, const ShapeSource& shapes, std::uint64_t random);

/// Those of `incoming` that may come into the window `box`. A shape stays out where a piece of its drawing was taken out
/// there and is not to come back (`not_back`): where exactly a piece comes in is not known before. All may come in where
/// fewer than half would be left.
std::vector<IncomingShape> let_into(const Box& box, const std::vector<IncomingShape>& incoming,
                                    const std::vector<FormerPiece>& not_back, const Period& period,
                                    const ShapeSource& shapes);

}  // namespace tessera
