// How a drawing's style is measured.
#pragma once

#include "core/style/style_features.h"
#include "core/style/style_raster.h"

namespace tessera {

/// Unknown where nothing is drawn.
StyleFeatures measure_style(const StyleRaster& raster);

}  // namespace tessera
