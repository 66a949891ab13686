// The structural similarity of two grey pictures (Wang, Bovik, Sheikh, Simoncelli 2004): whether light and dark lie in
// the same places, whatever the colours.
#pragma once

#include "core/geometry/grid.h"

namespace tessera {

/// Side of the windows that are compared, px.
inline constexpr int kSsimWindow_px = 7;

/// The mean over all windows that lie in the picture as a whole, -1 to 1; 1: the pictures are equal. Greys are 0 to
/// 255. `weight` (0..1) is how much each pixel counts, all of the same size. With weights of 1 it is what scikit-image
/// gives by default. Where the picture is narrower than a window, the window is as narrow. 1 where nothing counts.
double ssim(const Grid<float>& x, const Grid<float>& y, const Grid<float>& weight);

}  // namespace tessera
