// The allowed sizes of pieces from place to place: small where there is detail, large where there is none.
// kernels/stances.cl does the same look-up, bit for bit.
#pragma once

#include "core/geometry/cell_lookup.h"
#include "core/geometry/grid.h"

namespace tessera {

/// A grid over the canvas from its upper left corner on. A value is the fraction of a shape's range of sizes: 0, only
/// the smallest size, to 1, all sizes.
struct SizeMap {
  Grid<float> part;
  float cells_per_px = 1;

  /// Bilinear look-up; points beyond the map get the value at its edge.
  float at(Vec2 p_px) const {
    const CellLookup c(p_px, cells_per_px, part.width(), part.height());
    return (part(c.left, c.upper) * (1 - c.s) + part(c.right, c.upper) * c.s) * (1 - c.t) +
           (part(c.left, c.lower) * (1 - c.s) + part(c.right, c.lower) * c.s) * c.t;
  }
};

}  // namespace tessera
