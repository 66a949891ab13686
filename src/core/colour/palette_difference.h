// The difference between a drawing's colours and a palette.
#pragma once

#include <span>

#include "core/colour/colour_grid.h"

namespace tessera {

/// The mean over the grid's cells, weighted by their drawn part, of the CIEDE2000 to the nearest colour of the palette
/// (at least one). 0 if the grid is empty.
float palette_difference(const ColourGrid& grid, std::span<const Lab> palette);

}  // namespace tessera
