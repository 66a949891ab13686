// Bilinear look-up in a grid of cells over the canvas, with values at the middles of the cells. kernels/cell_lookup.cl
// does the same in OpenCL C, bit for bit.
#pragma once

#include <algorithm>

#include "core/geometry/vec2.h"

namespace tessera {

/// The four cells around a point and the point's place between their middles. Points beyond the grid are clamped to it.
struct CellLookup {
  int left, right, upper, lower;
  float s, t;

  /// `p_px`: canvas px; the grid begins at the canvas' upper left corner.
  CellLookup(Vec2 p_px, float cells_per_px, int width, int height) {
    const float u = std::clamp(p_px.x * cells_per_px - 0.5f, 0.f, float(width - 1));
    const float v = std::clamp(p_px.y * cells_per_px - 0.5f, 0.f, float(height - 1));
    left = int(u);
    upper = int(v);
    right = std::min(left + 1, width - 1);
    lower = std::min(upper + 1, height - 1);
    s = u - float(left);
    t = v - float(upper);
  }
};

}  // namespace tessera
