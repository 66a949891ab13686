// Pairs found in any order give the reference's selection: local minima along each level's closed curve, the best few of each shape.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <random>

#include "core/settings/tuning.h"
#include "worker/pair_choice.h"

namespace tessera::worker {
namespace test_pair_choice {

constexpr u32 kShapes = 40;

MatchRecord two_levels() {
  MatchRecord match{};
  match.shapes = kShapes;
  match.level_count = 2;
  match.level[0] = {0, 8, 0, 0};
  match.level[1] = {8, 16, 0, 0};
  match.sources = 24;
  return match;
}

bool same(const std::vector<PairRecord>& a, const std::vector<PairRecord>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const PairRecord& x, const PairRecord& y) {
    return x.sample == y.sample && x.source == y.source && x.distance == y.distance;
  });
}

/// Selects pairs as select_pairs() of core/matching/pair_selection.cpp does on its way round each curve. `distance` covers all sources.
std::vector<PairRecord> plainly_selected(const std::vector<u32>& distance, u32 reach, const MatchRecord& match) {
  std::vector<PairRecord> selected;
  for (u32 shape = 0; shape < match.shapes; ++shape) {
    std::vector<PairRecord> minima;
    for (u32 k = 0; k < match.level_count; ++k) {
      const u32 first = shape * match.sources + match.level[k].first;
      const u32 n = match.level[k].count;
      for (u32 j = 0; j < n; ++j) {
        const u32 d = distance[first + j];
        if (d < reach && d <= distance[first + (j + n - 1) % n] && d < distance[first + (j + 1) % n]) {
          minima.push_back({9, first + j, d});
        }
      }
    }
    std::stable_sort(minima.begin(), minima.end(),
                     [](const PairRecord& a, const PairRecord& b) { return a.distance < b.distance; });
    minima.resize(std::min<std::size_t>(minima.size(), kPairsPerShape));
    selected.insert(selected.end(), minima.begin(), minima.end());
  }
  return selected;
}

/// Few different distances give plateaus, and minima at the ends of curves.
RC_GTEST_PROP(FoundPairs, are_those_that_the_reference_selects, ()) {
  const MatchRecord match = two_levels();
  std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
  const auto values = *rc::gen::inRange<std::uint32_t>(2, 40);
  const auto reach = *rc::gen::inRange<std::uint32_t>(1, 40);
  std::vector<u32> distance(kShapes * match.sources);
  for (u32& d : distance) d = random() % 5 == 0 ? ~0u : u32(random() % values);
  std::vector<PairKey> found;
  for (u32 source = 0; source < distance.size(); ++source) {
    if (distance[source] < reach) found.push_back(pair_key({9, source, distance[source]}));
  }
  std::shuffle(found.begin(), found.end(), random);
  RC_ASSERT(same(docked_pairs(9, found, match), plainly_selected(distance, reach, match)));
}

}  // namespace test_pair_choice
}  // namespace tessera::worker
