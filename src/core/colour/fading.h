// How scores fade by colours. kernels/colour.cl does the same, bit for bit.
#pragma once

#include "core/base/portable_math.h"

namespace tessera {

inline constexpr float kEvenFading = 20;  // halvings; twice as many are never reached

/// What is left after so many halvings, 0 or more: 2^-halvings at first, then ever less is lost, so that numbers stay
/// normal and more halvings leave less whatever the weight.
inline float faded(float halvings) {
  constexpr float kMost = 2 * kEvenFading;
  return portable_exp2(halvings <= kEvenFading ? -halvings : kEvenFading * kEvenFading / halvings - kMost);
}

}  // namespace tessera
