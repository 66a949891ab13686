// Poses in which shapes of a library may lie on a query, found by the PADs of both (paper, section 3.3).
#pragma once

#include <vector>

#include "core/recognition/posed_shape.h"
#include "core/recognition/possible_scales.h"

namespace tessera {

/// One pose for each pair of a PAD of the query and one of its nearest PADs in the library whose key points agree. A
/// pair of widths (the query's and a level's of kSmoothingLevels) belongs to scales within half an octave, as curves
/// agree only if they are smoothed alike.
std::vector<PosedShape> pad_poses(const Query& query, const KnownShapes& shapes, const PossibleScales& scales);

}  // namespace tessera
