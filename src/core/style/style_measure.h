// Measures the style of a drawing.
#pragma once

#include "core/style/style_features.h"
#include "core/style/style_raster.h"

namespace tessera {

/// The features of the drawing; unknown if nothing is drawn.
StyleFeatures measure_style(const StyleRaster& raster);

}  // namespace tessera
