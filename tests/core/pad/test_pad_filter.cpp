// The filter of bytes loses no pair: every near PAD passes.
#include "core/pad/pad_filter.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace tessera {
namespace test_pad_filter {

bool within(std::uint8_t byte, std::uint8_t low, std::uint8_t high) { return low <= byte && byte <= high; }

bool passes(const QuantisedPad& source, const PadWindow& window, int levels) {
  bool all = true;
  for (std::size_t e = 0; e < std::size_t(2 * (levels - 1)); ++e) {
    all &= within(pad_byte(source.element[e]), window.low[e], window.high[e]);
  }
  return all;
}

QuantisedPad random_pad() {
  QuantisedPad pad;
  for (std::uint16_t& element : pad.element) element = *rc::gen::arbitrary<std::uint16_t>();
  return pad;
}

/// A PAD whose elements differ from those of `pad` by at most `reach`.
QuantisedPad random_neighbour(const QuantisedPad& pad, int reach) {
  QuantisedPad neighbour;
  for (std::size_t e = 0; e < pad.element.size(); ++e) {
    const int moved = int(pad.element[e]) + *rc::gen::inRange(-reach, reach + 1);
    neighbour.element[e] = std::uint16_t(std::clamp(moved, 0, 65535));
  }
  return neighbour;
}

RC_GTEST_PROP(PadFilter, passes_every_pair_within_reach, ()) {
  const int levels = *rc::gen::inRange(2, kMaxPadLevels + 1);
  const auto reach = *rc::gen::inRange<std::uint32_t>(1, kPadSteps + 2);
  const QuantisedPad target = random_pad();
  const QuantisedPad source = random_neighbour(target, int(reach));
  const PadWindow window = pad_window(target, reach);
  RC_ASSERT(passes(source, window, levels) || pad_distance(target, source, levels) >= reach);
}

TEST(PadFilter, KeepsOutWhatIsFar) {
  QuantisedPad target;
  target.element[3] = 30000;
  QuantisedPad source = target;
  source.element[3] = 30000 + 4 * 256;
  const PadWindow window = pad_window(target, 2 * 256);
  EXPECT_TRUE(within(pad_byte(target.element[3]), window.low[3], window.high[3]));
  EXPECT_FALSE(within(pad_byte(source.element[3]), window.low[3], window.high[3]));
}

/// The ends of the bytes decide. With a reach below half a byte, at most two bytes pass.
RC_GTEST_PROP(PadFilter, keeps_out_all_bytes_of_which_none_is_near, ()) {
  const QuantisedPad target = random_pad();
  const auto reach = *rc::gen::inRange<int>(1, 3000);
  const PadWindow window = pad_window(target, std::uint32_t(reach));
  for (std::size_t e = 0; e < target.element.size(); ++e) {
    const int last_of_low = window.low[e] * 256 + 255;
    const int first_of_high = window.high[e] * 256;
    RC_ASSERT(target.element[e] - last_of_low < reach);
    RC_ASSERT(first_of_high - target.element[e] < reach);
  }
}

RC_GTEST_PROP(PadFilter, passes_every_length_in_the_window, ()) {
  const float middle = float(*rc::gen::inRange(1, 1 << 20)) / 16384;
  const float least = middle / (1 + float(*rc::gen::inRange(0, 1000)) / 250);
  const float most = middle * (1 + float(*rc::gen::inRange(0, 1000)) / 250);
  const ScaleWindow window = scale_window(least, most);
  for (const float length : {least, middle, most}) RC_ASSERT(within(scale_byte(length), window.low, window.high));
  if (most < 30 && least > 0.01f) {
    RC_ASSERT(!within(scale_byte(most * 1.2f), window.low, window.high));
    RC_ASSERT(!within(scale_byte(least / 1.2f), window.low, window.high));
  }
}

TEST(PadFilter, SignsFitTheirOwnAndFlatOnes) {
  for (const float a : {-1.f, 0.f, 1.f}) {
    for (const float b : {-1.f, 0.f, 1.f}) EXPECT_EQ((sign_byte(a) & sign_byte(b)) != 0, a * b >= 0);
  }
}

}  // namespace test_pad_filter
}  // namespace tessera
