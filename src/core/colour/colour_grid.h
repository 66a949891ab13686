// The colours of a drawing on a coarse grid over its bounding box. The library stores this grid, and matching compares
// it with the colours that a piece covers.
#pragma once

#include <array>
#include <cstdint>

#include "core/colour/lab.h"
#include "core/geometry/grid.h"
#include "core/geometry/vec2.h"

namespace tessera {

inline constexpr int kColourSide = 4;  // cells of the grid in each direction
inline constexpr int kColourCells = kColourSide * kColourSide;

/// Cells row by row. A cell has four bytes: lightness (255 = 100), a + 128, b + 128, and the drawn part of the cell
/// (255 = all).
struct ColourGrid {
  std::array<std::uint8_t, 4 * kColourCells> bytes{};

  /// Whether the colours are known; libraries of older versions have none.
  bool known() const;

  friend bool operator==(const ColourGrid&, const ColourGrid&) = default;
};

/// A drawing or a part of it, px.
struct ColourRaster {
  Grid<Lab> colour;
  Grid<float> alpha;    // 0..1
  Vec2 origin_px;       // upper left corner of the upper left pixel
  Vec2 pixel_px{1, 1};  // width and height of a pixel
};

/// The colour grid of the box [low_px, high_px).
ColourGrid make_colour_grid(const ColourRaster& raster, Vec2 low_px, Vec2 high_px);
/// The grid mirrored: x -> -x.
ColourGrid mirrored(const ColourGrid& grid);

/// The root mean square difference of the cells' colours from their mean: Lab, with a and b counted half.
float own_contrast(const ColourGrid& grid);

/// The colour grid in the shape frame, laid out for look-ups.
struct ColourModel {
  std::array<Vec2, kColourCells> at{};  // middle of each cell
  std::array<Lab, kColourCells> colour{};
  std::array<float, kColourCells> part{};  // fraction of the drawing in each cell, 1 in all; all 0: unknown
  Lab mean;
  float cell = 0;  // side of a square with the area of a cell
};

/// Makes the model of a grid over the box [low, high], shape units.
ColourModel make_colour_model(const ColourGrid& grid, Vec2 low, Vec2 high);

}  // namespace tessera
