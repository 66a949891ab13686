// The index of PADs: it orders all PADs, its boxes hold their PADs, and few boxes lie near a target.
#include "core/pad/pad_index.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace tessera {
namespace test_pad_index {

constexpr int kElements = 8;

bool holds(const PadBox& box, const PadBytes& pad) {
  for (std::size_t e = 0; e < std::size_t(kElements); ++e) {
    if (pad.element[e] < box.low[e] || pad.element[e] > box.high[e]) return false;
  }
  return pad.scale >= box.scale_low && pad.scale <= box.scale_high && (pad.sign & box.signs) == pad.sign;
}

/// Some PADs are spread over all bytes, some are alike, as those of straight sides.
std::vector<PadBytes> random_pads(std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<PadBytes> pads(count);
  for (PadBytes& pad : pads) {
    const bool alike = random() % 4 == 0;
    for (std::uint8_t& element : pad.element) element = std::uint8_t(alike ? 128 + random() % 2 : random() % 256);
    pad.scale = std::uint8_t(100 + random() % 80);
    pad.sign = std::uint8_t(1 + random() % 3);
  }
  return pads;
}

RC_GTEST_PROP(PadIndex, orders_all_pads_into_boxes_that_hold_them, ()) {
  const auto count = *rc::gen::inRange<std::size_t>(0, 20'000);
  const std::vector<PadBytes> pads = random_pads(count, *rc::gen::arbitrary<std::uint32_t>());
  const PadIndex index = make_pad_index(pads, kElements);
  std::vector<std::uint32_t> sorted = index.order;
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::uint32_t> all(count);
  std::iota(all.begin(), all.end(), 0u);
  RC_ASSERT(sorted == all);
  RC_ASSERT(index.blocks.size() == (count + kIndexFanOut - 1) / kIndexFanOut);
  RC_ASSERT(index.nodes.size() == (index.blocks.size() + kIndexFanOut - 1) / kIndexFanOut);
  for (std::size_t i = 0; i < count; ++i) {
    RC_ASSERT(holds(index.blocks[i / kIndexFanOut], pads[index.order[i]]));
    RC_ASSERT(holds(index.nodes[i / kIndexFanOut / kIndexFanOut], pads[index.order[i]]));
  }
}

/// Enough PADs for several threads to split the branches.
TEST(PadIndex, ManyPadsAreInBoxesThatHoldThem) {
  const std::vector<PadBytes> pads = random_pads(150'000, 5);
  const PadIndex index = make_pad_index(pads, kElements);
  std::vector<bool> seen(pads.size());
  for (std::size_t i = 0; i < pads.size(); ++i) {
    ASSERT_FALSE(seen[index.order[i]]);
    seen[index.order[i]] = true;
    ASSERT_TRUE(holds(index.blocks[i / kIndexFanOut], pads[index.order[i]]));
  }
}

/// The program fixes the order by itself, independent of the standard library.
/// PADs keep their order within a block, and equal PADs keep their order over all.
TEST(PadIndex, PadsOfABlockKeepTheirOrder) {
  std::vector<PadBytes> pads = random_pads(20'000, 6);
  for (PadBytes& pad : pads) pad.sign = 1;
  const std::vector<std::uint32_t> order = pad_order(pads, kElements);
  for (std::size_t i = 1; i < order.size(); ++i) {
    ASSERT_TRUE(i % kIndexFanOut == 0 || order[i - 1] < order[i]) << i;
  }
  std::fill(pads.begin(), pads.end(), pads.front());
  std::vector<std::uint32_t> places(pads.size());
  std::iota(places.begin(), places.end(), 0u);
  EXPECT_EQ(pad_order(pads, kElements), places);
}

/// A box is as small as possible: some PAD lies at each bound.
TEST(PadIndex, BoxesAreTight) {
  const std::vector<PadBytes> pads = random_pads(5000, 7);
  const PadIndex index = make_pad_index(pads, kElements);
  for (std::size_t b = 0; b < index.blocks.size(); ++b) {
    PadBox expected;
    for (std::size_t i = b * kIndexFanOut; i < std::min<std::size_t>(pads.size(), (b + 1) * kIndexFanOut); ++i) {
      const PadBytes& pad = pads[index.order[i]];
      for (std::size_t e = 0; e < pad.element.size(); ++e) {
        expected.low[e] = std::min(expected.low[e], pad.element[e]);
        expected.high[e] = std::max(expected.high[e], pad.element[e]);
      }
      expected.scale_low = std::min(expected.scale_low, pad.scale);
      expected.scale_high = std::max(expected.scale_high, pad.scale);
      expected.signs |= pad.sign;
    }
    EXPECT_EQ(index.blocks[b], expected) << "block " << b;
  }
}

/// The PADs lie around few centres. A target near one centre meets few blocks of the index; in the original order it would meet all of
/// them.
TEST(PadIndex, FewBlocksLieNearATarget) {
  std::mt19937 random(3);
  std::vector<PadBytes> pads(64 * 256);
  for (std::size_t i = 0; i < pads.size(); ++i) {
    for (std::size_t e = 0; e < pads[i].element.size(); ++e) {
      pads[i].element[e] = std::uint8_t((i % 256 * (2 * e + 3) + random() % 8) % 256);
    }
    pads[i].scale = 128;
    pads[i].sign = std::uint8_t(1 + i % 2);
  }
  const PadIndex index = make_pad_index(pads, kElements);
  std::size_t met = 0;
  for (const PadBox& box : index.blocks) {
    bool near = (box.signs & pads[0].sign) != 0;
    for (std::size_t e = 0; e < std::size_t(kElements); ++e) {
      near = near && pads[0].element[e] + 8 >= box.low[e] && pads[0].element[e] <= box.high[e] + 8;
    }
    met += near;
  }
  EXPECT_LT(met, index.blocks.size() / 20);
}

/// All blocks except one have a single sign, so half of them cannot hold a target's pairs.
TEST(PadIndex, SignsMeetInOneBlock) {
  std::vector<PadBytes> pads = random_pads(10'000, 5);
  for (PadBytes& pad : pads) pad.sign = pad.sign == 3 ? 2 : pad.sign;
  const PadIndex index = make_pad_index(pads, kElements);
  const auto mixed =
      std::count_if(index.blocks.begin(), index.blocks.end(), [](const PadBox& b) { return b.signs == 3; });
  EXPECT_LE(mixed, 1);
}

}  // namespace test_pad_index
}  // namespace tessera
