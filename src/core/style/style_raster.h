// A drawing as a raster for style measures: at a fixed size, on white.
#pragma once

#include <cstdint>

#include "core/colour/lab.h"
#include "core/geometry/grid.h"

namespace tessera {

/// The square root of the drawn area, px. Lines of 1 % of the drawing's size are then 2 px wide.
inline constexpr int kStyleUnit_px = 224;
/// The longest side. Long and thin drawings are measured at a smaller size for it.
inline constexpr int kMostStyleSide_px = 640;
/// White around the drawing, so that its boundary has an outside.
inline constexpr int kStyleMargin_px = 6;

struct StyleRaster {
  Grid<Lab> colour;               // over white
  Grid<std::uint8_t> inside;      // 1 in the drawing and the area it encloses; 0 outside, also on the raster's rim
  float unit_px = kStyleUnit_px;  // the square root of the drawn area
};

/// The drawing with the area it encloses. Outside is what can be reached from the rim through pixels that are hardly
/// drawn on (alpha below a half).
Grid<std::uint8_t> enclosed_by(const Grid<float>& alpha);

}  // namespace tessera
