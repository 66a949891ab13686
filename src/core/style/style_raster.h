// A drawing as its style is measured: at one size, on white.
#pragma once

#include <cstdint>

#include "core/colour/lab.h"
#include "core/geometry/grid.h"

namespace tessera {

/// The square root of the drawn area, px: lines of 1 % of the drawing's size are 2 px wide.
inline constexpr int kStyleUnit_px = 224;
/// Drawings that are long and thin are measured smaller, as this is the longest side.
inline constexpr int kMostStyleSide_px = 640;
/// White around the drawing, so that its boundary has an outside.
inline constexpr int kStyleMargin_px = 6;

struct StyleRaster {
  Grid<Lab> colour;               // over white
  Grid<std::uint8_t> inside;      // 1 where the drawing is, with what it encloses; 0 outside, as on the raster's rim
  float unit_px = kStyleUnit_px;  // the square root of the area that is drawn on
};

/// What white reaches from the rim through what is hardly drawn on (alpha below a half) is outside.
Grid<std::uint8_t> enclosed_by(const Grid<float>& alpha);

}  // namespace tessera
