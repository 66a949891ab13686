// Makes a library shape from a traced silhouette.
#pragma once

#include "core/shape/outline.h"
#include "core/shape/shape.h"

namespace tessera {

inline constexpr int kOuterPoints = 512;     // of Outline::curves[0]
inline constexpr int kLeastHolePoints = 16;  // of a hole; otherwise in proportion to its length

/// Makes all parts that follow from the outline alone: outline, measures, field, levels, and the place of the shape
/// frame in the artwork (Artwork::centroid_px, unit_px). The caller adds name, colour and the rest of the artwork.
Shape make_shape(const TracedOutline& traced, const PadParameters& pad);

}  // namespace tessera
