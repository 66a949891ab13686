// Random dockings of a very large library are drawn from a deck: runs of its shapes, which differ for each question.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/matching/deck.h"
#include "core/settings/tuning.h"

namespace tessera {
namespace test_deck {

constexpr std::uint32_t kLarge = 1'000'000;

std::vector<TargetSample> samples_of(std::uint32_t edge, std::uint32_t pass = 0) {
  std::vector<TargetSample> samples(3);
  for (TargetSample& sample : samples) {
    sample.id = SampleId{edge++};
    sample.pass = pass;
  }
  return samples;
}

TEST(Deck, IsTheWholeLibraryUpToALimit) {
  const Deck whole = draw_deck(1, samples_of(7), kWholeDeck, kWholeDeck, 500);
  EXPECT_TRUE(whole.open.empty());
  EXPECT_TRUE(whole.near.empty());
  EXPECT_FALSE(draw_deck(1, samples_of(7), kWholeDeck + 1, kWholeDeck + 1, 500).open.empty());
}

TEST(Deck, HoldsAllOfAFewShapesThatMayStand) {
  EXPECT_TRUE(draw_deck(1, samples_of(7), kLarge, kDeckRuns * kDeckRun, 0).open.empty());
  EXPECT_TRUE(draw_deck(1, samples_of(7), kLarge, kLarge, kNearDeckRuns * kNearDeckRun).near.empty());
}

TEST(Deck, IsRunsOfPlacesInOrder) {
  for (const std::uint32_t all : {kLarge, kWholeDeck + 1, kWholeDeck + 63}) {
    const Deck deck = draw_deck(3, samples_of(11), all, all, all / 4);
    EXPECT_TRUE(std::is_sorted(deck.open.begin(), deck.open.end()));
    EXPECT_EQ(std::set(deck.open.begin(), deck.open.end()).size(), deck.open.size());
    EXPECT_GT(deck.open.size(), kDeckRuns * kDeckRun * 9 / 10) << "few runs overlap";
    EXPECT_LE(deck.open.size(), kDeckRuns * kDeckRun);
    EXPECT_LT(deck.open.back(), all);
    std::set<std::uint32_t> runs;
    for (const std::uint32_t place : deck.open) runs.insert(place / kDeckRun);
    EXPECT_LE(runs.size(), kDeckRuns);
    EXPECT_LE(deck.near.size(), kNearDeckRuns * kNearDeckRun);
    EXPECT_LT(deck.near.back(), all / 4);
  }
}

/// The deck is the same for every part that is asked. It differs for other samples, another pass and another seed.
TEST(Deck, FollowsFromTheQuestion) {
  const auto open = [](std::uint64_t seed, const std::vector<TargetSample>& samples) {
    return draw_deck(seed, samples, kLarge, kLarge, 0).open;
  };
  const auto first = open(1, samples_of(20));
  EXPECT_EQ(open(1, samples_of(20)), first);
  EXPECT_NE(open(2, samples_of(20)), first);
  EXPECT_NE(open(1, samples_of(21)), first);
  EXPECT_NE(open(1, samples_of(20, 1)), first);
}

/// In the long run every shape is drawn equally often.
TEST(Deck, FavoursNoPartOfTheLibrary) {
  constexpr std::uint32_t kParts = 10;
  constexpr std::uint32_t kQuestions = 400;
  std::vector<double> drawn(kParts, 0);
  for (std::uint32_t question = 0; question < kQuestions; ++question) {
    for (const std::uint32_t place : draw_deck(1, samples_of(10 * question), kLarge, kLarge, 0).open) {
      drawn[place / (kLarge / kParts)] += 1;
    }
  }
  const double even = double(kQuestions * kDeckRuns * kDeckRun) / kParts;
  for (const double part : drawn) EXPECT_NEAR(part, even, 0.12 * even);
}

}  // namespace test_deck
}  // namespace tessera
