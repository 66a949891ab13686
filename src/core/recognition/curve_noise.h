// Noise of traced and drawn curves.
#pragma once

#include "core/recognition/curve.h"

namespace tessera {

/// The curve without noise of up to some times `sigma`; itself where it has none. Noise makes a curve longer, and a width
/// along it is then less of the shape than it seems; so the curve is smoothed by `sigma` along its length, which is
/// measured anew, until that makes it hardly shorter. The stairs of pixels are no noise at a `sigma` of 1.5 px.
Curve without_noise(Curve curve, float sigma);

}  // namespace tessera
