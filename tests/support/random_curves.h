// Random smooth closed curves for property tests: the same seed gives the same curve.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "core/geometry/closed_curve.h"

namespace tessera::test {

/// `points` points at equal arclength. The interior is on the left, the perimeter is about 6 to 9, and the curve has no symmetry.
inline std::vector<Vec2> random_curve(std::uint32_t seed, int points) {
  std::mt19937 bits(seed);
  const auto uniform = [&](float low, float high) { return low + (high - low) * float(bits() >> 8) / 16777216.f; };
  struct Wave {
    float amplitude;
    float phase;
  };
  std::vector<Wave> waves;
  for (int k = 2; k <= 9; ++k) waves.push_back({uniform(0.2f, 0.5f) / float(k), uniform(0.f, 6.283f)});
  std::vector<Vec2> curve;
  for (int i = 0; i < 4096; ++i) {
    const float angle = 6.2831853f * float(i) / 4096;
    float radius = 1;
    for (std::size_t k = 0; k < waves.size(); ++k) {
      radius += waves[k].amplitude * std::cos(float(k + 2) * angle + waves[k].phase);
    }
    curve.push_back(Vec2{std::cos(angle), std::sin(angle)} * std::max(0.25f, radius));
  }
  return resampled_closed(curve, points);
}

}  // namespace tessera::test
