#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "core/ranks/partition.h"

namespace tessera {
namespace test_partition {

std::vector<std::uint64_t> some_weights() {
  return *rc::gen::container<std::vector<std::uint64_t>>(rc::gen::inRange<std::uint64_t>(0, 1000));
}

std::uint64_t weight_of(const std::vector<std::uint64_t>& weights, const ShapeRange& range) {
  return std::accumulate(weights.begin() + range.begin, weights.begin() + range.end, std::uint64_t(0));
}

RC_GTEST_PROP(BalancedRanges, FollowOneAnotherOverAllItems, ()) {
  const std::vector<std::uint64_t> weights = some_weights();
  const int parts = *rc::gen::inRange(1, 20);
  const std::vector<ShapeRange> ranges = balanced_ranges(weights, parts);
  RC_ASSERT(int(ranges.size()) == parts);
  RC_ASSERT(ranges.front().begin == 0u);
  RC_ASSERT(ranges.back().end == weights.size());
  for (std::size_t i = 1; i < ranges.size(); ++i) RC_ASSERT(ranges[i].begin == ranges[i - 1].end);
}

RC_GTEST_PROP(BalancedRanges, NoneWeighsMoreThanTheAverageAndTheHeaviestItem, ()) {
  const std::vector<std::uint64_t> weights = some_weights();
  const int parts = *rc::gen::inRange(1, 20);
  const std::uint64_t total = weight_of(weights, {0, std::uint32_t(weights.size())});
  const std::uint64_t heaviest = weights.empty() ? 0 : *std::max_element(weights.begin(), weights.end());
  for (const ShapeRange& range : balanced_ranges(weights, parts)) {
    RC_ASSERT(weight_of(weights, range) <= total / parts + 1 + heaviest);
  }
}

RC_GTEST_PROP(BalancedRanges, NoneIsEmptyAsLongAsThereAreItems, ()) {
  const std::vector<std::uint64_t> weights = some_weights();
  const std::size_t parts = *rc::gen::inRange<std::size_t>(1, 20);
  const std::vector<ShapeRange> ranges = balanced_ranges(weights, int(parts));
  for (std::size_t i = 0; i < std::min(parts, weights.size()); ++i) RC_ASSERT(ranges[i].begin < ranges[i].end);
}

TEST(BalancedRanges, DividesEqualWeightsEvenly) {
  const std::vector<ShapeRange> ranges = balanced_ranges(std::vector<std::uint64_t>(10, 320), 4);
  std::vector<std::uint32_t> sizes;
  for (const ShapeRange& range : ranges) sizes.push_back(range.end - range.begin);
  EXPECT_EQ(std::accumulate(sizes.begin(), sizes.end(), 0u), 10u);
  for (const std::uint32_t size : sizes) EXPECT_TRUE(size == 2 || size == 3) << size;
}

TEST(BalancedRanges, DoesNotOverflow) {
  const std::uint64_t heavy = std::uint64_t(1) << 61;
  const std::vector<ShapeRange> ranges = balanced_ranges(std::vector<std::uint64_t>(6, heavy), 3);
  for (const ShapeRange& range : ranges) EXPECT_EQ(range.end - range.begin, 2u);
}

RC_GTEST_PROP(EvenRange, CoversTheLibraryEvenly, ()) {
  const int shapes = *rc::gen::inRange(1, 1000);
  const int workers = *rc::gen::inRange(1, 40);
  std::uint32_t next = 0;
  for (int worker = 0; worker < workers; ++worker) {
    const ShapeRange part = even_range(std::size_t(shapes), worker, workers);
    RC_ASSERT(part.begin == next);
    RC_ASSERT(int(part.end - part.begin) <= shapes / workers + 1);
    next = part.end;
  }
  RC_ASSERT(next == std::uint32_t(shapes));
}

TEST(BalancedRanges, NeedsAPart) { EXPECT_THROW(balanced_ranges({}, 0), std::invalid_argument); }

std::vector<double> some_speeds() {
  const auto speed = rc::gen::map(rc::gen::inRange(-20, 20), [](int halvings) { return std::exp2(0.5 * halvings); });
  return *rc::gen::nonEmpty(rc::gen::container<std::vector<double>>(speed));
}

std::vector<std::size_t> sizes_of(const std::vector<ShapeRange>& ranges) {
  std::vector<std::size_t> sizes;
  for (const ShapeRange& range : ranges) sizes.push_back(range.end - range.begin);
  return sizes;
}

RC_GTEST_PROP(RangesBySpeed, FollowOneAnotherOverAllItems, ()) {
  const std::size_t items = *rc::gen::inRange<std::size_t>(0, 3000);
  const std::vector<double> speeds = some_speeds();
  const std::vector<ShapeRange> ranges = ranges_by_speed(items, speeds);
  RC_ASSERT(ranges.size() == speeds.size());
  RC_ASSERT(ranges.front().begin == 0u);
  RC_ASSERT(ranges.back().end == items);
  for (std::size_t i = 1; i < ranges.size(); ++i) RC_ASSERT(ranges[i].begin == ranges[i - 1].end);
}

RC_GTEST_PROP(RangesBySpeed, NoneHasMoreThanItsShareAndOneItem, ()) {
  const std::size_t items = *rc::gen::inRange<std::size_t>(0, 3000);
  const std::vector<double> speeds = some_speeds();
  const std::vector<std::size_t> sizes = sizes_of(ranges_by_speed(items, speeds));
  const double all = std::accumulate(speeds.begin(), speeds.end(), 0.0);
  for (std::size_t p = 0; p < speeds.size(); ++p) {
    RC_ASSERT(double(sizes[p]) <= double(items) * speeds[p] / all + 1 + 1e-6);
  }
}

RC_GTEST_PROP(RangesBySpeed, NoneIsEmptyAsLongAsThereAreItems, ()) {
  const std::size_t items = *rc::gen::inRange<std::size_t>(0, 60);
  const std::vector<std::size_t> sizes = sizes_of(ranges_by_speed(items, some_speeds()));
  for (std::size_t p = 0; p < std::min(items, sizes.size()); ++p) RC_ASSERT(sizes[p] > 0u);
}

TEST(RangesBySpeed, AreInProportionToTheSpeeds) {
  using Sizes = std::vector<std::size_t>;
  EXPECT_EQ(sizes_of(ranges_by_speed(1000, std::vector{3.0, 1.0})), (Sizes{750, 250}));
  EXPECT_EQ(sizes_of(ranges_by_speed(7, std::vector{1.0, 1.0, 1.0})), (Sizes{2, 3, 2}));
  EXPECT_EQ(sizes_of(ranges_by_speed(100'100, std::vector{1.0, 1000.0})), (Sizes{100, 100'000}));
  EXPECT_EQ(sizes_of(ranges_by_speed(100, std::vector{1000.0, 1.0, 1.0})), (Sizes{98, 1, 1})) << "one at least";
}

TEST(RangesBySpeed, WhatAPartCannotHoldGoesToTheOthersBySpeed) {
  using Sizes = std::vector<std::size_t>;
  const auto sizes = [](std::size_t items, const std::vector<double>& speeds, const Sizes& most) {
    return sizes_of(ranges_by_speed(items, speeds, most));
  };
  EXPECT_EQ(sizes(1000, {3, 1}, {1000, 1000}), (Sizes{750, 250}));
  EXPECT_EQ(sizes(1000, {3, 1}, {600, 1000}), (Sizes{600, 400}));
  EXPECT_EQ(sizes(1000, {3, 1}, {600, 400}), (Sizes{600, 400})) << "just so";
  EXPECT_EQ(sizes(1000, {6, 3, 1}, {100, 1000, 1000}), (Sizes{100, 675, 225}));
  EXPECT_EQ(sizes(1000, {6, 3, 1}, {100, 500, 1000}), (Sizes{100, 500, 400})) << "who takes over may become full";
  EXPECT_EQ(sizes(10, {1, 1}, {0, 10}), (Sizes{0, 10}));
  EXPECT_THROW(sizes(1000, {3, 1}, {600, 399}), std::invalid_argument);
  EXPECT_THROW(sizes(1000, {3, 1}, {1000}), std::invalid_argument);
}

RC_GTEST_PROP(RangesBySpeed, NoneHasMoreThanItCanHold, ()) {
  const std::vector<double> speeds = some_speeds();
  std::vector<std::size_t> most;
  for (std::size_t p = 0; p < speeds.size(); ++p) most.push_back(*rc::gen::inRange<std::size_t>(0, 300));
  const std::size_t room = std::accumulate(most.begin(), most.end(), std::size_t(0));
  const std::size_t items = *rc::gen::inRange<std::size_t>(0, room + 1);
  const std::vector<ShapeRange> ranges = ranges_by_speed(items, speeds, most);
  RC_ASSERT(ranges.front().begin == 0u);
  RC_ASSERT(ranges.back().end == items);
  for (std::size_t p = 1; p < ranges.size(); ++p) RC_ASSERT(ranges[p].begin == ranges[p - 1].end);
  const std::vector<std::size_t> sizes = sizes_of(ranges);
  for (std::size_t p = 0; p < sizes.size(); ++p) RC_ASSERT(sizes[p] <= most[p]);
}

TEST(RangesBySpeed, NeedSpeeds) {
  EXPECT_THROW(ranges_by_speed(5, {}), std::invalid_argument);
  EXPECT_THROW(ranges_by_speed(5, std::vector{1.0, 0.0}), std::invalid_argument);
  EXPECT_THROW(ranges_by_speed(5, std::vector{1.0, std::numeric_limits<double>::infinity()}), std::invalid_argument);
}

std::vector<int> some_breadths() {
  return *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 200)));
}

std::uint64_t weight_of(const std::vector<std::uint64_t>& weights, const std::vector<std::size_t>& items) {
  std::uint64_t sum = 0;
  for (const std::size_t item : items) sum += weights[item];
  return sum;
}

RC_GTEST_PROP(FairShares, HaveEveryItemOnce, ()) {
  const std::vector<std::uint64_t> weights = some_weights();
  const std::vector<int> breadths = some_breadths();
  const auto shares = fair_shares(weights, breadths);
  RC_ASSERT(shares.size() == breadths.size());
  std::vector<int> times(weights.size(), 0);
  for (const auto& share : shares) {
    for (const std::size_t item : share) ++times.at(item);
  }
  RC_ASSERT(times == std::vector<int>(weights.size(), 1));
}

RC_GTEST_PROP(FairShares, NoneWeighsMoreThanItsPartOfAllAndTheHeaviestItem, ()) {
  const std::vector<std::uint64_t> weights = some_weights();
  const std::vector<int> breadths = some_breadths();
  const std::uint64_t total = std::accumulate(weights.begin(), weights.end(), std::uint64_t(0));
  const std::uint64_t heaviest = weights.empty() ? 0 : *std::max_element(weights.begin(), weights.end());
  const int breadth = std::accumulate(breadths.begin(), breadths.end(), 0);
  const auto shares = fair_shares(weights, breadths);
  for (std::size_t p = 0; p < shares.size(); ++p) {
    RC_ASSERT(weight_of(weights, shares[p]) <= total * breadths[p] / breadth + 1 + heaviest);
  }
}

TEST(FairShares, HeaviestFirstAndOfEqualOnesTheFirst) {
  const std::vector<std::uint64_t> weights{1, 5, 5, 2};
  const std::vector<int> breadths{1, 2};
  const std::vector<std::vector<std::size_t>> shares{{1}, {2, 3, 0}};
  EXPECT_EQ(fair_shares(weights, breadths), shares);
}

TEST(FairShares, NeedAPart) { EXPECT_THROW(fair_shares({}, {}), std::invalid_argument); }

}  // namespace test_partition
}  // namespace tessera
