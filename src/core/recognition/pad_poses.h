// Poses in which shapes of a library may lie on a query, by the PADs of both (paper, section 3.3).
#pragma once

#include <vector>

#include "core/recognition/posed_shape.h"
#include "core/recognition/possible_scales.h"

namespace tessera {

/// One pose for each pair of a PAD of the query and one of its nearest in the library whose key points agree. Smoothing by
/// one width on the query's side and one of kSmoothingLevels on the shape's belong to scales of half an octave, as curves
/// agree only where they are smoothed alike.
std::vector<PosedShape> pad_poses(const Query& query, const KnownShapes& shapes, const PossibleScales& scales);

}  // namespace tessera
