// The pool's order and its spatial index, against a look at every candidate.
#include "core/collage/pool.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>
#include <optional>
#include <tuple>

#include "core/settings/tuning.h"

namespace tessera {
namespace test_pool {

TEST(Pool, KeepsTheBestInATotalOrder) {
  Pool pool;
  std::vector<Candidate> candidates;
  for (std::uint32_t i = 0; i < 7; ++i) {
    Candidate c;
    c.shape = ShapeId{10 - i};
    c.score = i < 5 ? 0.5f : 0.1f * float(i);
    candidates.push_back(c);
  }
  pool.put(SampleId{1}, candidates, false);
  const Pool::Entry& entry = pool.entries().at(SampleId{1});
  ASSERT_EQ(entry.candidates.size(), std::size_t(kPoolPerSample));
  EXPECT_TRUE(entry.truncated);
  EXPECT_EQ(entry.candidates[0].shape, ShapeId{4});
  EXPECT_EQ(entry.candidates[1].shape, ShapeId{5});
  EXPECT_EQ(entry.candidates[2].shape, ShapeId{6});  // equal scores: the lower shape first
  EXPECT_EQ(entry.candidates[3].shape, ShapeId{7});
}

/// Candidates with few different scores, so that ties occur.
Candidate any_candidate() {
  Candidate c;
  c.shape = ShapeId{*rc::gen::inRange(0u, 5u)};
  c.source = *rc::gen::inRange(0u, 100u);
  c.score = 0.1f * float(*rc::gen::inRange(1, 8));
  c.window.x0 = *rc::gen::inRange(-20, 300);
  c.window.y0 = *rc::gen::inRange(-20, 300);
  c.window.x1 = c.window.x0 + *rc::gen::inRange(1, 120);
  c.window.y1 = c.window.y0 + *rc::gen::inRange(1, 120);
  return c;
}

SampleId any_sample(std::uint32_t samples) { return SampleId{*rc::gen::inRange(0u, samples)}; }

void put_any(Pool& pool, std::uint32_t samples) {
  std::vector<Candidate> candidates(*rc::gen::inRange<std::size_t>(0, 6));
  for (Candidate& c : candidates) c = any_candidate();
  pool.put(any_sample(samples), candidates, false);
}

/// A factor for each shape; it can only fall, like preferences.
using Factors = std::vector<float>;

std::vector<Pool::Ranked> sorted(const Pool& pool, const Factors& factor) {
  std::vector<Pool::Ranked> all;
  for (const auto& [id, entry] : pool.entries()) {
    for (const Candidate& c : entry.candidates)
      all.push_back({c.score * factor[index_of(c.shape)], id, c.ordinal, c.stamp});
  }
  std::sort(all.begin(), all.end());
  return all;
}

TEST(Pool, BestFirstIsTheSortedOrderWhateverHappenedBefore) {
  EXPECT_TRUE(rc::check([] {
    Pool pool;
    Factors factor(5, 1.f);
    for (int round = 0; round < 12; ++round) {
      for (int i = 0; i < 10; ++i) put_any(pool, 40);
      pool.erase(any_sample(40));
      factor[*rc::gen::inRange<std::size_t>(0, 5)] *= 0.7f;
      for (const auto& [id, entry] : pool.entries()) {
        if (edge_number(id) % 3 != 0) continue;
        pool.review(id, [&](Candidate& c) {
          c.score = 0.1f * float(*rc::gen::inRange(1, 8));
          return c.source % 4 != 0;
        });
      }
      const std::vector<Pool::Ranked> expected = sorted(pool, factor);
      const std::size_t wanted = *rc::gen::inRange<std::size_t>(1, 60);
      std::vector<Pool::Ranked> found;
      pool.best_first([&](const Candidate& c) { return c.score * factor[index_of(c.shape)]; },
                      [&](const Pool::Ranked& ranked, const Candidate&) {
                        found.push_back(ranked);
                        return found.size() < wanted ? Pool::Visit::next : Pool::Visit::last;
                      });
      RC_ASSERT(found.size() == std::min(wanted, expected.size()));
      for (std::size_t i = 0; i < found.size(); ++i) {
        RC_ASSERT(found[i].value == expected[i].value);
        RC_ASSERT(found[i].stamp == expected[i].stamp);
      }
      if (found.empty()) continue;
      Pool::Ranked first = found.front();
      pool.at(first).score = 0.9f;
      pool.rank_again(first);
      if (found.size() > 1) pool.erase(found[1]);
    }
  }));
}

/// A restart relies on this: scores have changed since the candidates were put, and ties are broken by their places then.
TEST(Pool, PutBackElsewhereKeepsTheOrder) {
  EXPECT_TRUE(rc::check([] {
    Pool pool;
    for (int i = 0; i < 30; ++i) put_any(pool, 12);
    Pool again;
    for (const auto& [id, entry] : pool.entries()) {
      pool.review(id, [&](Candidate& c) {
        c.score = 0.1f * float(*rc::gen::inRange(1, 4));
        return c.source % 4 != 0;
      });
      again.put_back(id, entry.candidates, entry.truncated);
    }
    const auto order = [](Pool& of) {
      std::vector<std::tuple<SampleId, ShapeId, std::uint32_t>> found;
      of.best_first([](const Candidate& c) { return c.score; },
                    [&](const Pool::Ranked& r, const Candidate& c) {
                      found.emplace_back(r.sample, c.shape, c.source);
                      return Pool::Visit::next;
                    });
      return found;
    };
    RC_ASSERT(order(again) == order(pool));
  }));
}

TEST(Pool, ForgetsOutdatedRankings) {
  Pool pool;
  Candidate c;
  c.window = {0, 0, 5, 5};
  const auto best = [&] {
    std::vector<SampleId> samples;
    pool.best_first([](const Candidate& k) { return k.score; },
                    [&](const Pool::Ranked& r, const Candidate&) {
                      samples.push_back(r.sample);
                      return Pool::Visit::next;
                    });
    return samples;
  };
  for (int i = 0; i < 5000; ++i) {
    c.score = 1 + float(i);
    pool.put(SampleId(i % 3), {c}, false);
    if (i % 500 == 0) best();
  }
  EXPECT_EQ(best(), (std::vector{SampleId{1}, SampleId{0}, SampleId{2}}));
}

/// Puts enough candidates to cause a sweep of the outdated ones.
TEST(Pool, IsInOrderAfterASweep) {
  Pool pool;
  std::uint32_t state = 1;
  for (std::uint32_t i = 0; i < 6000; ++i) {
    Candidate c;
    c.window = {0, 0, 5, 5};
    c.score = float((state = state * 1664525u + 1013904223u) >> 8);
    pool.put(SampleId{i % 1500}, {c}, false);
  }
  std::vector<float> scores;
  pool.best_first([](const Candidate& c) { return c.score; },
                  [&](const Pool::Ranked& r, const Candidate&) {
                    scores.push_back(r.value);
                    return Pool::Visit::next;
                  });
  EXPECT_EQ(scores.size(), 1500u);
  EXPECT_TRUE(std::is_sorted(scores.rbegin(), scores.rend()));
}

/// Worth has fallen since these candidates were put off.
TEST(Pool, WhatIsPutOffIsVisitedOnceMoreBeforeWorseOnes) {
  EXPECT_TRUE(rc::check([] {
    Pool pool;
    Factors factor(5, 1.f);
    for (int i = 0; i < 30; ++i) put_any(pool, 12);
    const auto worth = [&](const Candidate& c) { return c.score * factor[index_of(c.shape)]; };
    const auto is_put_off = [](const Candidate& c) { return index_of(c.shape) == 2; };
    std::size_t visited = 0;
    pool.best_first(worth, [&](const Pool::Ranked&, const Candidate& c) {
      ++visited;
      return is_put_off(c) ? Pool::Visit::put_off : Pool::Visit::next;
    });
    factor[2] = 0.5f;
    const std::vector<Pool::Ranked> all = sorted(pool, factor);
    RC_ASSERT(visited == all.size());
    std::vector<std::uint64_t> expected, found;
    const std::size_t than = *rc::gen::inRange<std::size_t>(0, all.size());
    for (std::size_t i = 0; i < than; ++i) {
      if (is_put_off(pool.at(all[i]))) expected.push_back(all[i].stamp);
    }
    for (int time = 0; time < 2; ++time)
      pool.better_put_off(all[than], worth, [&](const Candidate& c) { found.push_back(c.stamp); });
    RC_ASSERT(found == expected);
    pool.best_first(worth, [&](const Pool::Ranked&, const Candidate& c) {
      RC_ASSERT(!is_put_off(c));
      return Pool::Visit::next;
    });
    pool.bring_back();
    std::vector<std::uint64_t> again;
    pool.best_first(worth, [&](const Pool::Ranked& ranked, const Candidate&) {
      again.push_back(ranked.stamp);
      return Pool::Visit::next;
    });
    RC_ASSERT(again.size() == all.size());
    for (std::size_t i = 0; i < all.size(); ++i) RC_ASSERT(again[i] == all[i].stamp);
  }));
}

/// The rest comes in the same order as without them.
TEST(Pool, WhatIsSetAsideComesAgainWhenItIsBroughtBack) {
  EXPECT_TRUE(rc::check([] {
    Pool pool;
    for (int i = 0; i < 30; ++i) put_any(pool, 12);
    const auto stamps = [&](std::uint32_t set_aside) {
      std::vector<std::uint64_t> found;
      pool.best_first([](const Candidate& c) { return c.score; },
                      [&](const Pool::Ranked& r, const Candidate& c) {
                        if (index_of(c.shape) == set_aside) return Pool::Visit::set_aside;
                        found.push_back(r.stamp);
                        return Pool::Visit::next;
                      });
      return found;
    };
    constexpr std::uint32_t kNone = 99;
    const std::vector<std::uint64_t> all = stamps(kNone);
    const std::vector<std::uint64_t> without = stamps(2);
    RC_ASSERT(stamps(kNone) == without);
    pool.bring_back();
    RC_ASSERT(stamps(kNone) == all);
    std::size_t of_shape = 0;
    for (const auto& [id, entry] : pool.entries()) {
      for (const Candidate& c : entry.candidates) of_shape += index_of(c.shape) == 2;
    }
    RC_ASSERT(without.size() + of_shape == all.size());
  }));
}

TEST(Pool, FindsWhatAChangeReaches) {
  EXPECT_TRUE(rc::check([] {
    Pool pool;
    for (int i = 0; i < 60; ++i) put_any(pool, 80);
    for (int i = 0; i < 10; ++i) pool.erase(any_sample(80));
    const Window changed = any_candidate().window;
    std::vector<SampleId> found = pool.reached_by(changed);
    std::sort(found.begin(), found.end());
    RC_ASSERT(std::adjacent_find(found.begin(), found.end()) == found.end());
    for (const auto& [id, entry] : pool.entries()) {
      const bool reached = std::any_of(entry.candidates.begin(), entry.candidates.end(),
                                       [&](const Candidate& c) { return c.window.overlaps(changed); });
      if (reached) RC_ASSERT(std::binary_search(found.begin(), found.end(), id));
    }
  }));
}

}  // namespace test_pool
}  // namespace tessera
