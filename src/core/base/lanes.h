// Numbers in 16 lanes, and their sum. Devices add 16 numbers at a time and the lanes at the end (kernels/lanes.cl).
// Host code that must give the same bits adds in this order, too.
#pragma once

#include <array>

namespace tessera {

inline constexpr int kLanes = 16;

using Lanes = std::array<float, kLanes>;

/// The sum of all lanes: adds the upper half of the lanes to the lower half, again and again.
inline float sum_of_lanes(Lanes v) {
  for (int half = kLanes / 2; half > 0; half /= 2) {
    for (int i = 0; i < half; ++i) v[i] += v[i + half];
  }
  return v[0];
}

}  // namespace tessera
