// Noise of traced and drawn curves.
#pragma once

#include "core/recognition/curve.h"

namespace tessera {

/// Removes noise up to some times `sigma` from the curve; a curve without noise is unchanged. Noise makes a curve
/// longer, so that a width along it corresponds to less of the shape. Therefore the curve is smoothed by `sigma` along
/// its length, which is then measured again, until smoothing hardly shortens it. At a `sigma` of 1.5 px the stairs of
/// pixels do not count as noise.
Curve without_noise(Curve curve, float sigma);

}  // namespace tessera
