// How a canvas is divided into windows: side by side, and elsewhere in each batch, so that no piece always lies on a
// cut.
#pragma once

#include <vector>

#include "core/geometry/period.h"
#include "core/geometry/polygon.h"

namespace tessera {

/// Cuts `canvas` into boxes at least half as wide and high as `least_px`, or as the canvas itself where that is less,
/// mostly one to two times as much, row by row.
/// `part_x`, `part_y`, in [0, 1): where the cuts lie. Where the canvas repeats itself its box is one period, and windows
/// go on beyond its far edges; elsewhere its own edges are no cuts.
std::vector<Box> cut_into_windows(const Box& canvas, const Period& period, float least_px, float part_x, float part_y);

}  // namespace tessera
