// The colours that a piece shows within its outline, as pictures average them.
#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <vector>

#include "artwork/drawers/drawers.h"
#include "core/colour/colour_grid.h"
#include "result/placed_shapes.h"

namespace tessera {

template <class T>
using OfCells = std::array<T, kColourCells>;

/// Over the box of the outline, by cells of its grid (core/colour/colour_grid.h).
struct DrawnColours {
  OfCells<cv::Vec3d> bgr{};  // mean of sRGB as it is coded
  OfCells<double> part{};    // of each cell that is drawn on
};

/// From the drawing's pixels: straight BGRA of its whole page.
DrawnColours drawn_colours(const cv::Mat& bgra, const Shape& shape);

/// As the library has them: means in CIELAB, and what is drawn beside the outline counts.
DrawnColours drawn_colours(const Shape& shape);

/// Of the shapes' thumbnails, by slot; of the library's grids where there is none.
std::vector<DrawnColours> drawn_colours(const PlacedShapes& shapes, Drawers& drawers);

}  // namespace tessera
