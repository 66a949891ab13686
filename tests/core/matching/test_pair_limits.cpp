// The distance up to which samples look for pairs: as far as the whole library requires, however it is estimated, and not much farther.
#include "core/matching/pair_limits.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>

#include "core/pad/pad_index.h"

namespace tessera {
namespace test_pair_limits {

/// Pairs of some samples, by segment and sample.
struct Pairs {
  std::vector<std::vector<DistanceHistogram>> of_segment;
  std::vector<DistanceHistogram> all;
};

/// Pairs that grow with a power of the distance, faster for some samples than for others. The segments are even or uneven.
Pairs random_pairs(std::size_t samples, std::size_t segments, bool even, std::mt19937& random) {
  Pairs pairs{std::vector(segments, std::vector<DistanceHistogram>(samples)), std::vector<DistanceHistogram>(samples)};
  for (std::size_t t = 0; t < samples; ++t) {
    const double density = std::pow(10, -4 + 6 * double(random() % 1000) / 1000);
    const double power = even ? 2 : double(random() % 5);
    for (std::vector<DistanceHistogram>& of_sample : pairs.of_segment) {
      const double factor = even ? 1 : double(random() % 3);
      for (std::size_t bin = 0; bin < std::size_t(kDistanceBins); ++bin) {
        const double mean = factor * density * std::pow(double(bin) + 0.5, power);
        of_sample[t][bin] = std::uint32_t(mean + double(random() % 1000) / 1000);
        pairs.all[t][bin] += of_sample[t][bin];
      }
    }
  }
  return pairs;
}

struct Asked {
  int estimates = 0;
  int looks = 0;
  std::vector<std::uint32_t> farthest;  // for each sample, in the whole library
};

std::vector<std::uint32_t> limits_of(const Pairs& pairs, std::uint64_t wanted, Asked& asked) {
  const std::size_t samples = pairs.all.size();
  asked.farthest.assign(samples, 0);
  const auto count = [&](const std::vector<std::uint32_t>& bins, std::uint32_t stride) {
    EXPECT_EQ(bins.size(), samples);
    ++(stride > 1 ? asked.estimates : asked.looks);
    std::vector<DistanceHistogram> counted;
    for (std::size_t t = 0; t < samples; ++t) {
      EXPECT_LE(bins[t], std::uint32_t(kDistanceBins));
      if (bins[t] == 0) continue;
      if (stride == 1) asked.farthest[t] = std::max(asked.farthest[t], bins[t]);
      DistanceHistogram& histogram = counted.emplace_back();
      for (std::size_t s = 0; s < pairs.of_segment.size(); s += stride) {
        for (std::uint32_t bin = 0; bin < bins[t]; ++bin) histogram[bin] += pairs.of_segment[s][t][bin];
      }
    }
    return counted;
  };
  return pair_limits(samples, wanted, std::uint32_t(pairs.of_segment.size()) * kSegmentShapes, count);
}

/// The limits equal those of the whole histograms, for estimated libraries and for small ones.
/// This holds even if the segments of the estimate say nothing about the others.
RC_GTEST_PROP(PairLimits, are_those_of_all_pairs, ()) {
  std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
  const auto samples = *rc::gen::inRange<std::size_t>(0, 20);
  const auto segments = *rc::gen::inRange<std::size_t>(1, 60);
  const auto wanted = *rc::gen::element<std::uint64_t>(0, 1, 6, 50, 200, 100'000, std::uint64_t(1) << 40);
  const Pairs pairs = random_pairs(samples, segments, *rc::gen::arbitrary<bool>(), random);
  Asked asked;
  const std::vector<std::uint32_t> limits = limits_of(pairs, wanted, asked);
  RC_ASSERT(limits.size() == samples);
  for (std::size_t t = 0; t < samples; ++t) RC_ASSERT(limits[t] == bin_limit_for(pairs.all[t], wanted));
}

TEST(PairLimits, SmallLibrariesAreNotEstimated) {
  std::mt19937 random(1);
  Asked asked;
  limits_of(random_pairs(10, 11, true, random), 200, asked);
  EXPECT_EQ(asked.estimates, 0);
  limits_of(random_pairs(10, 12, true, random), 200, asked);
  EXPECT_GT(asked.estimates, 0);
}

/// One look at the whole library is enough for nearly all samples, and goes hardly farther than necessary.
/// Pairs grow with the third power of the distance, so a quarter more pairs are 8 % farther.
TEST(PairLimits, AnEstimateTellsHowFarItWillBe) {
  std::mt19937 random(2);
  const Pairs pairs = random_pairs(200, 50, true, random);
  Asked asked;
  const std::vector<std::uint32_t> limits = limits_of(pairs, 200, asked);
  EXPECT_LE(asked.looks, 2);
  for (std::size_t t = 0; t < limits.size(); ++t) {
    EXPECT_LE(asked.farthest[t], std::max(3u, limits[t] + limits[t] / 6 + 2)) << "limit " << limits[t];
  }
}

TEST(PairLimits, AMatcherThatCountsOthersIsTold) {
  const auto count = [](const std::vector<std::uint32_t>&, std::uint32_t) { return std::vector<DistanceHistogram>(3); };
  EXPECT_THROW(pair_limits(4, 10, 100, count), std::logic_error);
}

}  // namespace test_pair_limits
}  // namespace tessera
