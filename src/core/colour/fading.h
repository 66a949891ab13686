// The fading of scores with colour differences. kernels/colour.cl computes the same, bit for bit.
#pragma once

#include "core/base/portable_math.h"

namespace tessera {

/// Halvings; up to here a score fades evenly; twice as many are never reached.
inline constexpr float kEvenFading = 20;

/// The factor that remains after this number of halvings (0 or more): 2^-halvings at first. Beyond kEvenFading it falls
/// ever more slowly. So numbers stay normal floats, and more halvings always leave less.
inline float faded(float halvings) {
  constexpr float kMost = 2 * kEvenFading;
  return portable_exp2(halvings <= kEvenFading ? -halvings : kEvenFading * kEvenFading / halvings - kMost);
}

}  // namespace tessera
