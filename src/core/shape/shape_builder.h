// The last step from a traced silhouette to a library shape.
#pragma once

#include "core/shape/outline.h"
#include "core/shape/shape.h"

namespace tessera {

inline constexpr int kOuterPoints = 512;     // of Outline::curves[0]
inline constexpr int kLeastHolePoints = 16;  // of a hole; otherwise in proportion to its length

/// Everything that follows from the outline alone: outline, measures, field, levels, and where the shape frame lies in
/// the artwork (Artwork::centroid_px, unit_px). Name, colour and the rest of the artwork are the caller's.
Shape make_shape(const TracedOutline& traced, const PadParameters& pad);

}  // namespace tessera
