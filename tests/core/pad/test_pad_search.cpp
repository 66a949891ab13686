// The search in the index finds the same PADs as a scan of all PADs, whatever levels the target lacks.
#include "core/pad/pad_search.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace tessera {
namespace test_pad_search {

constexpr int kLevels = 5;
constexpr int kElements = 2 * (kLevels - 1);

ArclengthPyramid random_pyramid(std::mt19937& random) {
  std::uniform_real_distribution<float> step(0.05f, 1);
  ArclengthPyramid pyramid;
  float left = 0, right = 0;
  for (int i = 0; i < kLevels; ++i) {
    pyramid.left[std::size_t(i)] = left += step(random);
    pyramid.right[std::size_t(i)] = right += step(random);
  }
  pyramid.convexity = float(int(random() % 3) - 1);
  return pyramid;
}

std::vector<PadBytes> random_pads(std::size_t count, std::mt19937& random) {
  std::vector<PadBytes> pads;
  for (std::size_t i = 0; i < count; ++i) {
    const ArclengthPyramid p = random_pyramid(random);
    pads.push_back(pad_bytes(quantised(make_pad(p, kLevels)), p.left[2] + p.right[2], p.convexity));
  }
  return pads;
}

/// The distance of one PAD as pad_search.h defines it.
float stated_distance(const PadBytes& pad, const PadTarget& target) {
  if ((pad.sign & target.sign) == 0) return 2;
  if (pad.scale < target.scales.low || pad.scale > target.scales.high) return 2;
  float distance = 0;
  const auto length = [](std::uint8_t byte, int level) { return (float(byte) + 0.5f) / 256 * float(1 << level); };
  const auto side = [&](int known, const std::array<float, kMaxPadLevels>& wanted, auto element) {
    const float last = known < kLevels ? length(pad.element[std::size_t(element(known - 1))], known - 1) : 1;
    for (int i = 0; i + 1 < known; ++i) {
      const float own = length(pad.element[std::size_t(element(i))], i) / last / float(1 << i);
      distance = std::max(distance, std::abs(own - wanted[std::size_t(i)]));
    }
  };
  side(target.left_levels, target.left, [](int i) { return kLevels - 2 - i; });
  side(target.right_levels, target.right, [](int i) { return kLevels - 1 + i; });
  return distance;
}

RC_GTEST_PROP(PadSearch, finds_what_a_scan_finds, ()) {
  std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
  const auto count = *rc::gen::inRange<std::size_t>(0, 9000);
  const std::vector<PadBytes> pads = random_pads(count, random);
  const double share = *rc::gen::element(kDockingScaleShare, kRecognitionScaleShare);
  const PadSearch search(make_pad_index(pads, kElements, share), pads, kLevels);
  PadTarget target =
      make_pad_target(random_pyramid(random), *rc::gen::inRange(2, kLevels + 1), *rc::gen::inRange(2, kLevels + 1));
  if (*rc::gen::arbitrary<bool>()) target.scales = scale_window(1, 2);
  const float reach = *rc::gen::element(0.02f, 0.1f, 0.5f);
  const auto most = *rc::gen::element<std::size_t>(1, 20, 100000);
  const auto odd = *rc::gen::arbitrary<bool>();
  const auto wanted = [&](std::uint32_t place) { return !odd || place % 2 == 1; };

  std::vector<PadHit> expected;
  for (std::uint32_t i = 0; i < count; ++i) {
    const float distance = stated_distance(pads[i], target);
    if (distance < reach && wanted(i)) expected.push_back({distance, i});
  }
  std::sort(expected.begin(), expected.end());
  const std::vector<PadHit> found = search.nearest(target, reach, most, wanted);
  RC_ASSERT(found.size() == std::min(most, expected.size()));
  for (std::size_t i = 0; i < found.size(); ++i) {
    // The operations have another order, so the last bits may differ, and with them the order of equal distances.
    RC_ASSERT(std::abs(found[i].distance - expected[i].distance) < 1e-5f);
    RC_ASSERT(std::abs(stated_distance(pads[found[i].place], target) - found[i].distance) < 1e-5f);
    RC_ASSERT(wanted(found[i].place));
    if (i > 0) RC_ASSERT(found[i - 1] < found[i]);  // RC_ASSERT evaluates both sides of ||
  }
}

TEST(PadSearch, FindsAPadByPartOfItsLevels) {
  std::mt19937 random(5);
  std::vector<ArclengthPyramid> pyramids;
  std::vector<PadBytes> pads;
  for (int i = 0; i < 2000; ++i) {
    pyramids.push_back(random_pyramid(random));
    pads.push_back(pad_bytes(quantised(make_pad(pyramids.back(), kLevels)), 1, pyramids.back().convexity));
  }
  const PadSearch search(make_pad_index(pads, kElements), pads, kLevels);
  const auto all = [](std::uint32_t) { return true; };
  for (std::uint32_t i = 0; i < 2000; i += 97) {
    const auto nearest = search.nearest(make_pad_target(pyramids[i], 4, 5), 0.05f, 1, all);
    ASSERT_EQ(nearest.size(), 1u);
    EXPECT_LT(nearest[0].distance, 0.02f) << "bytes are that coarse";
    const auto near = search.nearest(make_pad_target(pyramids[i], 4, 5), 0.05f, 2000, all);
    EXPECT_TRUE(std::any_of(near.begin(), near.end(), [&](const PadHit& hit) { return hit.place == i; }));
  }
}

TEST(PadSearch, OfNothingFindsNothing) {
  std::mt19937 random(1);
  const PadSearch search(make_pad_index({}, kElements), {}, kLevels);
  EXPECT_TRUE(search.nearest(make_pad_target(random_pyramid(random), 5, 5), 1, 10, [](auto) { return true; }).empty());
}

}  // namespace test_pad_search
}  // namespace tessera
