// The search for sizes at which every piece finds a place. Here all pieces fit up to a known factor.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <vector>

#include "core/matching/size_search.h"
#include "core/settings/tuning.h"

namespace tessera {
namespace test_size_search {

struct Searched {
  std::vector<float> factors;  // of the attempts, in order
  float fits = 0;              // the largest factor at which all found a place; 0: none
};

/// Searches with a least factor. All pieces find a place up to the factor `limit`; beyond it the share `placed(factor)` does.
template <class Placed>
Searched searched(float least_factor, float limit, Placed placed) {
  Searched result;
  SizeSearch search(least_factor);
  while (!search.over()) {
    const float factor = search.factor();
    result.factors.push_back(factor);
    if (factor <= limit) result.fits = std::max(result.fits, factor);
    search.end_attempt(factor <= limit ? 0 : 1, factor <= limit ? 1 : placed(factor));
    if (result.factors.size() > kMostAttempts) break;
  }
  return result;
}

float random_factor(int least_percent) { return float(*rc::gen::inRange(least_percent, 100)) / 100; }

RC_GTEST_PROP(SizeSearch, FindsNearlyTheLargestSizes, ()) {
  const float least = random_factor(1) * 0.2f;
  const float limit = std::max(least, random_factor(1));
  const float part = random_factor(0);  // the visible share of a shortage
  const Searched found = searched(
      least, limit, [&](float factor) { return 1 - part * (1 - double(limit) * limit / (double(factor) * factor)); });
  RC_ASSERT(found.factors.size() <= kMostAttempts);
  RC_ASSERT(found.fits >= least);
  for (const float factor : found.factors) RC_ASSERT(factor >= least && factor <= 1);
  if (found.factors.size() < kMostAttempts) {
    for (const float factor : found.factors) RC_ASSERT(factor <= limit || factor * 1.001f >= found.fits);
    float too_large = 10;
    for (const float factor : found.factors) too_large = factor > limit ? std::min(too_large, factor) : too_large;
    if (too_large <= 1) RC_ASSERT(too_large <= 1.101f * found.fits);
  }
}

RC_GTEST_PROP(SizeSearch, TriesTheLeastSizesWhereNothingFits, ()) {
  const float least = random_factor(1);
  const double placed = double(*rc::gen::inRange(0, 1000)) / 1000;
  const Searched found = searched(least, 0, [&](float) { return placed; });
  RC_ASSERT(found.factors.size() < kMostAttempts);
  RC_ASSERT(found.factors.back() == least);
  for (std::size_t i = 1; i < found.factors.size(); ++i) RC_ASSERT(found.factors[i] < found.factors[i - 1]);
}

TEST(SizeSearch, EndsWhereAllFindAPlaceAtOnce) {
  EXPECT_EQ(searched(0.1f, 1, [](float) { return 0.5; }).factors, std::vector<float>{1});
}

/// One of a hundred pieces is missing. The sizes need a small step down, and then half a step up.
TEST(SizeSearch, ASmallShortageTakesASmallStepDownAndAHalfUp) {
  const Searched found = searched(0.1f, 0.985f, [](float) { return 0.99; });
  ASSERT_EQ(found.factors.size(), 3u);
  EXPECT_FLOAT_EQ(found.factors[1], 0.98f);
  EXPECT_FLOAT_EQ(found.factors[2], std::sqrt(0.98f));
  EXPECT_EQ(found.fits, found.factors[1]);
}

TEST(SizeSearch, WhereNothingWasPlacedSizesAreHalved) {
  const Searched found = searched(0.01f, 0.3f, [](float) { return 0.; });
  ASSERT_GT(found.factors.size(), 3u);
  EXPECT_EQ(found.factors[1], 0.5f);
  EXPECT_EQ(found.factors[2], 0.25f);
  EXPECT_GT(found.factors[3], 0.25f) << "up again";
}

TEST(SizeSearch, WithoutASearchTheFirstAttemptIsTheOnlyOne) {
  const SizeSearch none;
  EXPECT_TRUE(none.over());
  EXPECT_EQ(none.factor(), 1);
}

TEST(SizeSearch, GoesOnFromItsStateAndFromNoOther) {
  SizeSearch search(0.2f);
  search.end_attempt(7, 0.5);
  SizeSearch other(0.2f);
  ASSERT_TRUE(other.restore(search.state()));
  search.end_attempt(0, 1);
  other.end_attempt(0, 1);
  EXPECT_EQ(other.state(), search.state());
  const auto refused = [&](auto change) {
    SizeSearchState state = search.state();
    change(state);
    return !SizeSearch(0.2f).restore(state);
  };
  EXPECT_FALSE(refused([](SizeSearchState&) {}));
  EXPECT_TRUE(refused([](SizeSearchState& s) { s.attempt = kMostAttempts; }));
  EXPECT_TRUE(refused([](SizeSearchState& s) { s.factor = 0.1f; }));
  EXPECT_TRUE(refused([](SizeSearchState& s) { s.factor = 1.5f; }));
  EXPECT_TRUE(refused([](SizeSearchState& s) { s.fits = 0.1f; }));
  EXPECT_TRUE(refused([](SizeSearchState& s) { s.too_large = 2; }));
  EXPECT_FALSE(SizeSearch().restore(search.state())) << "of a job that does not search";
  EXPECT_TRUE(SizeSearch().restore(SizeSearch().state()));
}

}  // namespace test_size_search
}  // namespace tessera
