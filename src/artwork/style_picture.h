// A drawing made ready for measuring its style (core/style/style_measure.h).
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/style/style_raster.h"

namespace tessera {

/// `premultiplied`: BGRA of 8 bits, of what is drawn on. At one size, so that the style of a drawing does not depend on
/// that of its picture. Empty where nothing is drawn.
StyleRaster style_raster_of(const cv::Mat& premultiplied);

}  // namespace tessera
