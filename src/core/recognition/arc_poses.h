// Poses in which shapes of a library may lie on a query, found by arcs of both (known_arcs.h). They help where a
// boundary is straight or noisy and PADs find few poses.
#pragma once

#include <vector>

#include "core/recognition/posed_shape.h"
#include "core/recognition/possible_scales.h"

namespace tessera {

/// One pose for each pair of an arc of the query and one of its nearest arcs in the library whose scale is possible. If
/// the scale is known, only arcs of exactly the library's lengths are looked up.
std::vector<PosedShape> arc_poses(const Query& query, const KnownShapes& shapes, const PossibleScales& scales);

}  // namespace tessera
