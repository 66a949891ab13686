// Measures the areas between a drawing's lines and edges: flat colours, shades, texture.
#pragma once

#include <cstdint>

#include "core/style/style_raster.h"

namespace tessera {

struct StyleSurface {
  double texture = 0;  // the figures are those of StyleFeatures
  double shading = 0;
  double detail = 0;
  Grid<std::uint8_t> calm;  // 1 inside the drawing where no edge is near
};

StyleSurface style_surface(const StyleRaster& raster);

/// Bits of the colours where `calm`; of all of the drawing's colours if no pixel is calm.
double palette_bits(const StyleRaster& raster, const Grid<std::uint8_t>& calm);

}  // namespace tessera
