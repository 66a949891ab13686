// How large pieces may be from place to place: small where there is detail, large where there is none.
// kernels/stances.cl looks up the same, bit for bit.
#pragma once

#include "core/geometry/cell_lookup.h"
#include "core/geometry/grid.h"

namespace tessera {

/// Over the canvas from its upper left corner on: 0, only the smallest size there is for a shape, to 1, all of them.
struct SizeMap {
  Grid<float> part;
  float cells_per_px = 1;

  /// Bilinear; beyond the map what is at its edge.
  float at(Vec2 p_px) const {
    const CellLookup c(p_px, cells_per_px, part.width(), part.height());
    return (part(c.left, c.upper) * (1 - c.s) + part(c.right, c.upper) * c.s) * (1 - c.t) +
           (part(c.left, c.lower) * (1 - c.s) + part(c.right, c.lower) * c.s) * c.t;
  }
};

}  // namespace tessera
