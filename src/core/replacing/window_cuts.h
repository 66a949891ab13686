// Divides a canvas into windows side by side. The cuts lie elsewhere in each batch, so that no piece always lies on
// one.
#pragma once

#include <vector>

#include "core/geometry/period.h"
#include "core/geometry/polygon.h"

namespace tessera {

/// Cuts `canvas` into boxes, row by row. A box is mostly one to two times as wide and high as `least_px`, or as the
/// canvas if that is smaller. It is never less than half of that. `part_x`, `part_y` in [0, 1) shift the cuts. On a
/// canvas that repeats, `canvas` is one period and windows continue beyond its far edges; otherwise its own edges bound
/// the windows.
std::vector<Box> cut_into_windows(const Box& canvas, const Period& period, float least_px, float part_x, float part_y);

}  // namespace tessera
