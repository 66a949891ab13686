// Thins areas of pixels to lines one pixel wide (Zhang and Suen 1984: "A fast parallel algorithm for thinning digital
// patterns").
#pragma once

#include <cstdint>

#include "core/geometry/grid.h"

namespace tessera {

/// 1 where a thin line remains of the pixels that are 1 in `filled`, otherwise 0. The lines are connected like the areas,
/// also over corners. Only ends could be taken away without cutting a line. The outside of the grid counts as 0.
Grid<std::uint8_t> thinned(const Grid<std::uint8_t>& filled);

}  // namespace tessera
