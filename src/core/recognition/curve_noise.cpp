#include "core/recognition/curve_noise.h"

#include <algorithm>

namespace tessera {
namespace {

/// A curve that loses a larger fraction of its length has noise: the stairs of pixels are at most 8 % of it, corners a
/// few percent.
constexpr float kNoiseLoss = 0.12f;
constexpr int kMostRounds = 10;
/// A curve of fewer widths would lose its shape, too.
constexpr float kShortest = 20;
constexpr float kNoisyPointsOfWidth = 3;
constexpr float kLeastNoisyPoints = 48;
constexpr float kMostNoisyPoints = 20000;

}  // namespace

Curve without_noise(Curve curve, float sigma) {
  float length = length_of(curve);
  for (int round = 0; round < kMostRounds; ++round) {
    const float points = std::clamp(kNoisyPointsOfWidth * length / sigma, kLeastNoisyPoints, kMostNoisyPoints);
    Curve smooth = smoothed(resampled(curve, int(points)), sigma);
    const float left = length_of(smooth);
    if (left > (1 - kNoiseLoss) * length || left < kShortest * sigma) break;
    curve = std::move(smooth);
    length = left;
  }
  return curve;
}

}  // namespace tessera
