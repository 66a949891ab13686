#include "core/colour/palette_difference.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "core/colour/ciede2000.h"

namespace tessera {

float palette_difference(const ColourGrid& grid, std::span<const Lab> palette) {
  const ColourModel cells = make_colour_model(grid, {0, 0}, {1, 1});
  float mean = 0;
  for (std::size_t cell = 0; cell < kColourCells; ++cell) {
    if (cells.part[cell] == 0) continue;
    float nearest = std::numeric_limits<float>::infinity();
    for (const Lab& colour : palette) nearest = std::min(nearest, ciede2000(cells.colour[cell], colour));
    mean += cells.part[cell] * nearest;
  }
  return mean;
}

}  // namespace tessera
