// How far a drawing's colours are from those of a palette.
#pragma once

#include <span>

#include "core/colour/colour_grid.h"

namespace tessera {

/// CIEDE2000: of each cell to the nearest colour of the palette (one at least), the mean by what is drawn on. 0 where
/// the grid is empty.
float palette_difference(const ColourGrid& grid, std::span<const Lab> palette);

}  // namespace tessera
