// The colours that a piece shows within its outline, averaged like scaled-down pictures average them.
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

/// The colours in the bounding box of the outline, by cells of its grid (core/colour/colour_grid.h).
struct DrawnColours {
  OfCells<cv::Vec3d> bgr{};  // mean of encoded sRGB
  OfCells<double> part{};    // part of each cell that is drawn on
};

/// The colours from the drawing's pixels: straight BGRA of its whole page.
DrawnColours drawn_colours(const cv::Mat& bgra, const Shape& shape);

/// The colours from the library: means in CIELAB, which include what is drawn beside the outline.
DrawnColours drawn_colours(const Shape& shape);

/// The colours of all shapes, by slot, from their thumbnails; from the library's grids where there is no thumbnail.
std::vector<DrawnColours> drawn_colours(const PlacedShapes& shapes, Drawers& drawers);

}  // namespace tessera
