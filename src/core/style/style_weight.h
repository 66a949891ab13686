// The preference for drawings of the wished style.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/portable_math.h"

namespace tessera {

/// Distance at which a drawing is half as preferred, at weight 1. Two drawings at the mean distance differ by a factor
/// of about 16.
inline constexpr float kStyleHalving = 1;
/// Preference has steps, so that shapes share their stances (core/matching/stances.h): two per halving, and sixteen in
/// all. A drawing that is preferred 256 times less is placed only if no other fits.
inline constexpr int kStepsPerHalving = 2;
inline constexpr int kMostStyleSteps = 16;

/// The step of preference for a distance; 0 for the wished style.
inline int style_step(float distance, float weight) {
  const float steps = distance / kStyleHalving * weight * float(kStepsPerHalving);
  return int(std::min(float(kMostStyleSteps), std::floor(steps + 0.5f)));
}

inline float style_worth(int step) { return portable_exp2(-float(step) / float(kStepsPerHalving)); }

}  // namespace tessera
