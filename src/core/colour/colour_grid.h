// The colours of a drawing on a coarse grid over the box of its outline, as the library keeps them, and as colours of
// pieces are compared with what they cover.
#pragma once

#include <array>
#include <cstdint>

#include "core/colour/lab.h"
#include "core/geometry/grid.h"
#include "core/geometry/vec2.h"

namespace tessera {

inline constexpr int kColourSide = 4;  // cells of the grid, each way
inline constexpr int kColourCells = kColourSide * kColourSide;

/// Row by row; a cell: lightness (255 = 100), a + 128, b + 128, and the part of the cell that is drawn on (255 = all).
struct ColourGrid {
  std::array<std::uint8_t, 4 * kColourCells> bytes{};

  /// Libraries of older versions do not know.
  bool known() const;

  friend bool operator==(const ColourGrid&, const ColourGrid&) = default;
};

/// A drawing, or part of it, px.
struct ColourRaster {
  Grid<Lab> colour;
  Grid<float> alpha;    // 0..1
  Vec2 origin_px;       // upper left corner of the upper left pixel
  Vec2 pixel_px{1, 1};  // width and height of a pixel
};

/// Of the box [low, high).
ColourGrid make_colour_grid(const ColourRaster& raster, Vec2 low_px, Vec2 high_px);
/// x -> -x.
ColourGrid mirrored(const ColourGrid& grid);

/// How far the cells' colours lie from their mean, by the root of the mean square: Lab, a and b counted half.
float own_contrast(const ColourGrid& grid);

/// The grid in the shape frame, laid out for look-ups.
struct ColourModel {
  std::array<Vec2, kColourCells> at{};  // middle of each cell
  std::array<Lab, kColourCells> colour{};
  std::array<float, kColourCells> part{};  // of the drawing, 1 in all; all 0: nothing is known
  Lab mean;
  float cell = 0;  // side of a square as large as a cell
};

/// The outline lies in the box [low, high], shape units.
ColourModel make_colour_model(const ColourGrid& grid, Vec2 low, Vec2 high);

}  // namespace tessera
