// New shapes from old ones: mirrored and stretched outlines, for libraries larger than anyone has drawn.
#pragma once

#include "core/shape/shape.h"

namespace tessera {

/// Stretches by `factor` (above 0) along the direction `angle_rad` and by 1 / factor across it; mirrored first where
/// `mirrored`.
struct ShapeVariation {
  bool mirrored = false;
  float angle_rad = 0;
  float factor = 1;
};

/// The shape of the changed outline, built as any other: area 1, interior on the left, its own field and levels. The
/// name stays; the artwork, which does not fit any more, is left out.
Shape varied_shape(const Shape& shape, const ShapeVariation& variation, const PadParameters& pad);

}  // namespace tessera
