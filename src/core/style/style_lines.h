// Finds the dark lines of a drawing: contours and pen strokes.
#pragma once

#include "core/geometry/grid.h"
#include "core/style/style_raster.h"

namespace tessera {

/// The fraction of each pixel that is line, 0..1. A line is darker than the areas on both sides; morphological closing
/// fills it. The fraction is relative to the contrast that the line has nearby.
Grid<float> dark_lines(const StyleRaster& raster);

/// The perimeter of the area above 0, px, from the number of crossings with lines in eight directions (Cauchy and
/// Crofton).
double crofton_perimeter_px(const Grid<float>& mask);

}  // namespace tessera
