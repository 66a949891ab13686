// The structural similarity of two grey pictures (Wang, Bovik, Sheikh, Simoncelli 2004): whether light and dark are in
// the same places.
#pragma once

#include "core/geometry/grid.h"

namespace tessera {

/// Side of the compared windows, px.
inline constexpr int kSsimWindow_px = 7;

/// The mean over all windows inside the picture, -1 to 1; 1: the pictures are equal. Greys are 0 to 255. `weight`
/// (0..1) is the weight of each pixel; all grids have the same size. With weights of 1 the result is that of
/// scikit-image's defaults. If the picture is smaller than a window, the window is as small. 1 if no pixel has weight.
double ssim(const Grid<float>& x, const Grid<float>& y, const Grid<float>& weight);

}  // namespace tessera
