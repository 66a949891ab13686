// Noise is removed from a curve; a clean curve stays as it is.
#include "core/recognition/curve_noise.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>

#include "support/random_curves.h"

namespace tessera {
namespace test_curve_noise {

constexpr float kScale_px = 60;

/// A random curve with points 1 px apart.
Curve clean(std::uint32_t seed) {
  Curve curve{test::random_curve(seed, 2048), true};
  for (Vec2& p : curve.points) p = p * kScale_px;
  return resampled(curve, int(length_of(curve)));
}

Curve noisy(Curve curve, float noise_px, std::uint32_t seed) {
  std::mt19937 bits(seed);
  std::normal_distribution<float> noise(0, noise_px);
  const std::vector<Vec2> tangents = tangents_of(curve);
  for (std::size_t i = 0; i < tangents.size(); ++i) {
    curve.points[i] = curve.points[i] + Vec2{-tangents[i].y, tangents[i].x} * noise(bits);
  }
  return curve;
}

float root_mean_square_off(const Curve& curve, const Curve& truth) {
  double squares = 0;
  for (const Vec2 p : curve.points) {
    float nearest = 1e9f;
    for (const Vec2 q : truth.points) nearest = std::min(nearest, dot(p - q, p - q));
    squares += double(nearest) / double(curve.points.size());
  }
  return float(std::sqrt(squares));
}

RC_GTEST_PROP(WithoutNoise, LeavesTheShape, ()) {
  const auto seed = std::uint32_t(*rc::gen::inRange(0, 1000));
  const float noise_px = float(*rc::gen::inRange(2, 5));  // the smoothing of queries handles 1 px
  const Curve truth = clean(seed), given = noisy(truth, noise_px, seed + 1), left = without_noise(given, 1.5f);
  RC_LOG(std::to_string(length_of(given)) + " to " + std::to_string(length_of(left)));
  RC_ASSERT(length_of(given) > 1.3f * length_of(truth));
  RC_ASSERT(length_of(left) <
            1.5f * length_of(truth));  // smoothing ends when another step would shorten it by less than an eighth
  RC_ASSERT(length_of(left) > 0.9f * length_of(truth));
  RC_ASSERT(root_mean_square_off(left, truth) < 0.75f * root_mean_square_off(given, truth));
}

RC_GTEST_PROP(WithoutNoise, LeavesACleanCurveAsItIs, ()) {
  const Curve curve = clean(std::uint32_t(*rc::gen::inRange(0, 1000)));
  RC_ASSERT(without_noise(curve, 1.5f) == curve);
}

TEST(WithoutNoise, LeavesTheStairsOfPixels) {
  Curve stairs;
  for (int i = 0; i < 200; ++i) stairs.points.push_back({float(i), float(i / 3)});
  EXPECT_EQ(without_noise(stairs, 1.5f), stairs);
}

/// A blot smaller than the width would shrink to a point.
TEST(WithoutNoise, LeavesWhatIsSmall) {
  Curve blot{{}, true};
  for (int i = 0; i < 16; ++i)
    blot.points.push_back({2 * std::cos(0.3927f * float(i)), 2 * std::sin(0.3927f * float(i))});
  EXPECT_EQ(without_noise(blot, 1.5f), blot);
}

}  // namespace test_curve_noise
}  // namespace tessera
