// Lines of pixels made one pixel wide (Zhang and Suen 1984: "A fast parallel algorithm for thinning digital patterns").
#pragma once

#include <cstdint>

#include "core/geometry/grid.h"

namespace tessera {

/// 1 where a thin line is left of what is 1 in `filled`, else 0. The lines are connected as the areas were, over corners
/// too, and no pixel can be taken away that is not an end. Beyond the grid there is nothing.
Grid<std::uint8_t> thinned(const Grid<std::uint8_t>& filled);

}  // namespace tessera
