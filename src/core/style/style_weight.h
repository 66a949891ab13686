// How much less a drawing is preferred for being of another style.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/portable_math.h"

namespace tessera {

/// A drawing is preferred half as much for each so much of distance, at the weight 1: those that are as far apart as two
/// are in the mean are preferred some 16 times less.
inline constexpr float kStyleHalving = 1;
/// Steps of preference, so that shapes share their stances (core/matching/stances.h): two to each halving, and sixteen
/// in all, as what is preferred 256 times less is placed only where nothing else is left.
inline constexpr int kStepsPerHalving = 2;
inline constexpr int kMostStyleSteps = 16;

/// 0 for the style that is wished for.
inline int style_step(float distance, float weight) {
  const float steps = distance / kStyleHalving * weight * float(kStepsPerHalving);
  return int(std::min(float(kMostStyleSteps), std::floor(steps + 0.5f)));
}

inline float style_worth(int step) { return portable_exp2(-float(step) / float(kStepsPerHalving)); }

}  // namespace tessera
