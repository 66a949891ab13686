// Makes new shapes from old ones by mirroring and stretching, for libraries larger than anyone has drawn.
#pragma once

#include "core/shape/shape.h"

namespace tessera {

/// A variation: mirrored first if `mirrored`, then stretched by `factor` (above 0) along the direction `angle_rad` and
/// by 1 / factor across it.
struct ShapeVariation {
  bool mirrored = false;
  float angle_rad = 0;
  float factor = 1;
};

/// The shape of the changed outline, built like any other: area 1, interior on the left, its own field and levels. The
/// name stays; the artwork, which no longer fits, is left out.
Shape varied_shape(const Shape& shape, const ShapeVariation& variation, const PadParameters& pad);

}  // namespace tessera
