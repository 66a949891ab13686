// Dark lines of a drawing: contours and strokes of a pen.
#pragma once

#include "core/geometry/grid.h"
#include "core/style/style_raster.h"

namespace tessera {

/// How much of each pixel is line, 0..1: where the drawing is darker than what lies on both sides, which is what closing
/// fills, by the contrast that the line has near by.
Grid<float> dark_lines(const StyleRaster& raster);

/// The perimeter of what is above 0, px, by how often lines in eight directions cross it (Cauchy and Crofton).
double crofton_perimeter_px(const Grid<float>& mask);

}  // namespace tessera
