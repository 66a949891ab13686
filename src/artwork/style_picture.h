// Prepares a drawing for the measurement of its style (core/style/style_measure.h).
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/style/style_raster.h"

namespace tessera {

/// `premultiplied`: BGRA of 8 bits, of the part with the drawing. The result has a fixed size, so that the style does
/// not depend on the picture's size. Empty where nothing is drawn.
StyleRaster style_raster_of(const cv::Mat& premultiplied);

}  // namespace tessera
