// Properties of the descriptor that the paper states (section 3).
#include "core/pad/pad.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <numeric>

#include "core/geometry/closed_curve.h"
#include "core/geometry/similarity.h"
#include "core/shape/level_curve.h"
#include "support/random_curves.h"

namespace tessera {
namespace test_pad {

constexpr PadParameters kPad;
constexpr float kSigma = 0.05f;  // for curves about 7 long
constexpr int kPoints = 1024;

rc::Gen<std::uint32_t> any_seed() { return rc::gen::inRange<std::uint32_t>(1, 1u << 30); }

std::vector<ArclengthPyramid> pyramids(const std::vector<Vec2>& curve, float sigma, int samples) {
  return sample_pyramids(gaussian_smoothed(curve, sigma), sigma, samples, kPad);
}

std::vector<Vec2> transformed(const std::vector<Vec2>& curve, const Similarity& s) {
  std::vector<Vec2> result;
  for (const Vec2 p : curve) result.push_back(s.apply(p));
  return result;
}

float median(std::vector<float> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

TEST(Pad, LevelsGrow) {
  EXPECT_TRUE(rc::check([] {
    for (const ArclengthPyramid& p : pyramids(test::random_curve(*any_seed(), kPoints), kSigma, 64)) {
      for (int i = 1; i < kPad.levels; ++i) {
        RC_ASSERT(p.left[i] >= p.left[i - 1]);
        RC_ASSERT(p.right[i] >= p.right[i - 1]);
      }
    }
  }));
}

TEST(Pad, IsInvariantToRotationAndTranslation) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<Vec2> curve = test::random_curve(*any_seed(), kPoints);
    const float angle = 0.001f * float(*rc::gen::inRange(0, 6283));
    const Similarity turned{std::cos(angle), std::sin(angle), 0.3f, -0.2f};
    const auto before = pyramids(curve, kSigma, 64);
    const auto after = pyramids(transformed(curve, turned), kSigma, 64);
    std::vector<float> distances;
    for (std::size_t j = 0; j < before.size(); ++j) {
      distances.push_back(pad_distance(make_pad(before[j], 5), make_pad(after[j], 5), 5));
    }
    // A level may end where the curve is nearly straight. There, rounding of the positions moves the end most.
    RC_ASSERT(median(distances) < 5e-4f);
    RC_ASSERT(*std::max_element(distances.begin(), distances.end()) < 0.02f);
  }));
}

TEST(Pad, IsInvariantToTheStartPoint) {
  EXPECT_TRUE(rc::check([] {
    std::vector<Vec2> curve = gaussian_smoothed(test::random_curve(*any_seed(), kPoints), kSigma);
    const auto before = sample_pyramids(curve, kSigma, 64, kPad);
    const int shift = *rc::gen::inRange(1, 64);
    std::rotate(curve.begin(), curve.begin() + shift * (kPoints / 64), curve.end());
    const auto after = sample_pyramids(curve, kSigma, 64, kPad);
    for (int j = 0; j < 64; ++j) RC_ASSERT(after[j] == before[(j + shift) % 64]);
  }));
}

/// The same curve at another scale, sampled as densely as a raster of that scale: with other points and another count.
struct Rescaled {
  std::vector<ArclengthPyramid> original = {};
  std::vector<ArclengthPyramid> scaled = {};

  Rescaled(std::uint32_t seed, float scale, int samples) {
    const std::vector<Vec2> curve = test::random_curve(seed, 4096);
    const int count = int(kPoints * scale + 0.5f) / samples * samples;
    original = pyramids(resampled_closed(curve, kPoints), kSigma, samples);
    scaled = pyramids(transformed(resampled_closed(curve, count), {scale, 0, 0, 0}), kSigma * scale, samples);
  }
};

TEST(Pad, IsInvariantToScale) {
  EXPECT_TRUE(rc::check([] {
    const float scale = 0.25f * std::pow(16.f, 0.01f * float(*rc::gen::inRange(0, 101)));
    const Rescaled both(*any_seed(), scale, 64);
    std::vector<float> distances;
    for (int j = 0; j < 64; ++j) {
      distances.push_back(pad_distance(make_pad(both.original[j], 5), make_pad(both.scaled[j], 5), 5));
    }
    RC_ASSERT(median(distances) < 0.01f);
  }));
}

TEST(Pad, FindsTheTrueCounterpartAtAnotherScale) {
  constexpr int kSamples = 256;
  int found = 0;
  int asked = 0;
  for (std::uint32_t seed = 1; seed <= 12; ++seed) {
    const float scale = 0.25f * std::pow(16.f, float(seed - 1) / 11);
    const Rescaled both(seed, scale, kSamples);
    for (int j = 0; j < kSamples; j += 4) {
      const Pad query = make_pad(both.scaled[j], 5);
      int best = 0;
      float least = 1e9f;
      for (int k = 0; k < kSamples; ++k) {
        const float d = pad_distance(query, make_pad(both.original[k], 5), 5);
        if (d < least) least = d, best = k;
      }
      const int apart = std::min(std::abs(best - j), kSamples - std::abs(best - j));
      found += apart <= kSamples / 100;
      ++asked;
    }
  }
  EXPECT_GE(double(found) / asked, 0.85);
}

TEST(Pad, OfACircleIsOneSixteenthInEveryElement) {
  std::vector<Vec2> circle;
  for (int i = 0; i < kPoints; ++i) {
    const float angle = 6.2831853f * float(i) / kPoints;
    circle.push_back({std::cos(angle), std::sin(angle)});
  }
  for (const ArclengthPyramid& p : sample_pyramids(circle, 10.f, 16, kPad)) {
    const Pad pad = make_pad(p, 5);
    for (int i = 0; i < 8; ++i) EXPECT_NEAR(pad.element[i], 1.f / 16, 1e-3f);
    EXPECT_EQ(pad.convexity, 1);
  }
}

TEST(Pad, OfTheReversedCurveIsTheOutwardFlip) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<Vec2> curve = gaussian_smoothed(test::random_curve(*any_seed(), kPoints), kSigma);
    const std::vector<Vec2> backwards(curve.rbegin(), curve.rend());
    std::vector<Vec2> aligned = backwards;  // starts at the same point as the curve
    std::rotate(aligned.begin(), aligned.end() - 1, aligned.end());
    const auto forwards_pyramids = sample_pyramids(curve, kSigma, 64, kPad);
    const auto backwards_pyramids = sample_pyramids(aligned, kSigma, 64, kPad);
    for (int j = 0; j < 64; ++j) {
      const Pad flip = flipped(make_pad(forwards_pyramids[j], 5), 5);
      const Pad reversed = make_pad(backwards_pyramids[(64 - j) % 64], 5);
      RC_ASSERT(flip.convexity == reversed.convexity);
      for (int i = 0; i < 8; ++i) RC_ASSERT(std::abs(flip.element[i] - reversed.element[i]) < 1e-5f);
    }
  }));
}

TEST(Pad, OppositeConvexityAddsTheMagnitudes) {
  Pad p;
  p.element.fill(0.25f);
  p.convexity = 1;
  Pad q = p;
  EXPECT_EQ(pad_distance(p, q, 5), 0.f);
  q.convexity = -1;
  EXPECT_EQ(pad_distance(p, q, 5), 0.5f);
  q.convexity = 0;  // a flat element agrees with either sign
  EXPECT_EQ(pad_distance(p, q, 5), 0.f);
}

/// A stretch of one curve is pasted into another. Away from the joints, PADs depend only on the stretch.
TEST(Pad, OfAPastedStretchEqualsTheOriginal) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<Vec2> curve = test::random_curve(*any_seed(), kPoints);
    std::vector<Vec2> other(curve.begin(), curve.begin() + kPoints / 2 + 200);
    const Vec2 gap = other.front() - other.back();
    for (int i = 1; i < 400; ++i) {  // another way back to the start
      const float t = float(i) / 400;
      other.push_back(other[kPoints / 2 + 199] + gap * t + Vec2{gap.y, -gap.x} * (0.8f * std::sin(3.14159265f * t)));
    }
    const auto smooth = [](const std::vector<Vec2>& c) {
      // The filter reaches a fixed 8 points, so that the two curves differ only by the detour.
      std::vector<Vec2> result(c.size());
      for (std::size_t i = 0; i < c.size(); ++i) {
        Vec2 sum;
        for (int k = -8; k <= 8; ++k) sum = sum + c[(i + k + c.size()) % c.size()] * (1.f / 17);
        result[i] = sum;
      }
      return result;
    };
    other.resize(other.size() / 16 * 16);
    const auto before = sample_pyramids(smooth(curve), kSigma, kPoints / 16, kPad);
    const auto after = sample_pyramids(smooth(other), kSigma, int(other.size()) / 16, kPad);
    int compared = 0;
    const float spacing = closed_length(curve) / kPoints;
    for (int j = 0; j < kPoints / 2 + 200; j += 16) {
      const float to_joint = spacing * 0.9f * float(std::min(j, kPoints / 2 + 199 - j) - 10);
      if (std::max(before[j / 16].left[4], before[j / 16].right[4]) > to_joint) continue;
      RC_ASSERT(before[j / 16] == after[j / 16]);
      ++compared;
    }
    RC_PRE(compared > 3);
  }));
}

}  // namespace test_pad
}  // namespace tessera
