// How large pieces may be from place to place: small where there is detail, large where there is none.
// kernels/stances.cl looks up the same, bit for bit.
#pragma once

#include <algorithm>

#include "core/base/portable_math.h"
#include "core/geometry/grid.h"
#include "core/geometry/vec2.h"

namespace tessera {

/// Over the canvas from its upper left corner on, a node in the middle of each cell: 0, only the smallest size there is
/// for a shape, to 1, all of them.
struct SizeMap {
  Grid<float> part;
  float cells_per_px = 1;

  /// Bilinear; beyond the map what is at its edge.
  float at(Vec2 p_px) const {
    const auto clamped = [](float u, int side) { return std::clamp(u, 0.f, float(side - 1)); };
    const float u = clamped(p_px.x * cells_per_px - 0.5f, part.width());
    const float v = clamped(p_px.y * cells_per_px - 0.5f, part.height());
    const int i = int(u), j = int(v);
    const int right = std::min(i + 1, part.width() - 1), below = std::min(j + 1, part.height() - 1);
    const float s = u - float(i), t = v - float(j);
    return (part(i, j) * (1 - s) + part(right, j) * s) * (1 - t) +
           (part(i, below) * (1 - s) + part(right, below) * s) * t;
  }
};

}  // namespace tessera
