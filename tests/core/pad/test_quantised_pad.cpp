// PADs and key points in whole steps: as close to the exact ones as rounding allows, and safe with a damaged library.
#include "core/pad/quantised_pad.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "core/shape/model_sample.h"

namespace tessera {
namespace test_quantised_pad {

Pad random_pad() {
  Pad pad;
  for (float& element : pad.element) element = float(*rc::gen::inRange(0, 1 << 24)) / float(1 << 24);
  return pad;
}

RC_GTEST_PROP(QuantisedPad, distances_are_those_of_equation_1, ()) {
  const int levels = *rc::gen::inRange(2, kMaxPadLevels + 1);
  const Pad p = random_pad();
  const Pad q = random_pad();
  const float steps = float(pad_distance(quantised(p), quantised(q), levels));
  RC_ASSERT(std::abs(steps / float(kPadSteps) - pad_distance(p, q, levels)) <= 1.01f / float(kPadSteps));
}

TEST(QuantisedPad, EveryDistanceIsBelowAThresholdOfOneOrMore) {
  QuantisedPad zeros;
  QuantisedPad ones;
  ones.element.fill(65535);
  EXPECT_LT(pad_distance(zeros, ones, 5), pad_steps(1));
  EXPECT_EQ(pad_steps(4), pad_steps(1));
  EXPECT_EQ(pad_steps(0), 0u);
  EXPECT_EQ(pad_steps(0.5f), 32768u);
}

TEST(QuantisedPad, WhatIsNoNumberIsInRange) {
  Pad pad;
  pad.element = {std::nanf(""), -3, 7, std::numeric_limits<float>::infinity(), 0.5f};
  const QuantisedPad result = quantised(pad);
  EXPECT_EQ(result.element[0], 0);
  EXPECT_EQ(result.element[1], 0);
  EXPECT_EQ(result.element[2], 65535);
  EXPECT_EQ(result.element[3], 65535);
  EXPECT_EQ(result.element[4], 32768);
}

RC_GTEST_PROP(QuantisedPad, a_library_keeps_twelve_bits, ()) {
  QuantisedPad pad;
  for (std::uint16_t& element : pad.element) element = std::uint16_t(*rc::gen::inRange(0, 65536));
  const QuantisedPad kept = library_pad(pad);
  for (std::size_t e = 0; e < pad.element.size(); ++e) {
    RC_ASSERT(kept.element[e] % kLibraryPadSteps == 0u);
    // The error is at most half a step of the library. Values nearest to 65,536 become 65,520.
    RC_ASSERT(std::abs(int(kept.element[e]) - int(pad.element[e])) <= (pad.element[e] < 65528 ? 8 : 15));
  }
  RC_ASSERT(library_pad(kept) == kept);
}

RC_GTEST_PROP(ModelSample, a_library_keeps_half_the_bits_of_a_length, ()) {
  const float length = std::ldexp(1 + float(*rc::gen::inRange(0, 1 << 23)) / float(1 << 23), *rc::gen::inRange(-10, 6));
  const float kept = library_length(length);
  RC_ASSERT(std::bit_cast<std::uint32_t>(kept) % 65536 == 0u);
  RC_ASSERT(std::abs(kept - length) <= length / 256);
  RC_ASSERT(library_length(kept) == kept);
}

TEST(ModelSample, IsWhatALibraryKeeps) {
  ArclengthPyramid pyramid;
  for (int i = 0; i < kMaxPadLevels; ++i) {
    pyramid.left[std::size_t(i)] = 0.1f * float(i + 1);
    pyramid.right[std::size_t(i)] = 0.13f * float(i + 1);
  }
  const ModelSample sample = make_model_sample(pyramid, 5, keypoint_step(1));
  EXPECT_EQ(sample.pad, library_pad(quantised(make_pad(pyramid, 5))));
  EXPECT_NE(sample.pad, quantised(make_pad(pyramid, 5)));
  EXPECT_EQ(sample.scale_length, library_length(scale_length(pyramid, 5)));
  EXPECT_NE(sample.scale_length, scale_length(pyramid, 5));
}

RC_GTEST_PROP(ModelSample, key_points_stay_where_they_were, ()) {
  const float radius = float(*rc::gen::inRange(1, 1000)) / 100;
  ArclengthPyramid pyramid;
  for (Vec2& p : pyramid.keypoint) {
    p = {radius * float(*rc::gen::inRange(-1000, 1001)) / 1000, radius * float(*rc::gen::inRange(-1000, 1001)) / 1000};
  }
  for (int i = 0; i < kMaxPadLevels; ++i) pyramid.left[i] = pyramid.right[i] = float(i + 1);
  const Keypoints found =
      keypoints(make_model_sample(pyramid, kMaxPadLevels, keypoint_step(radius)), keypoint_step(radius));
  for (std::size_t i = 0; i < found.size(); ++i) RC_ASSERT(norm(found[i] - pyramid.keypoint[i]) < 1e-4f * radius);
}

}  // namespace test_quantised_pad
}  // namespace tessera
