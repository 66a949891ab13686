// Poses in which shapes of a library may lie on a query, by arcs of both (known_arcs.h): where a boundary is straight or
// noisy, PADs find few.
#pragma once

#include <vector>

#include "core/recognition/posed_shape.h"
#include "core/recognition/possible_scales.h"

namespace tessera {

/// One pose for each pair of an arc of the query and one of its nearest in the library that may have this scale.
/// Where the scale is known, arcs of exactly the library's lengths are looked up.
std::vector<PosedShape> arc_poses(const Query& query, const KnownShapes& shapes, const PossibleScales& scales);

}  // namespace tessera
