// What becomes of the pool's candidates when a piece is placed beside them.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <tuple>

#include "core/collage/objective.h"
#include "rounds_by_hand.h"

namespace tessera::master {
namespace {

using Edges = std::set<std::uint32_t>;

const std::vector<Shape>& library() {
  static const std::vector<Shape> shapes = test::synthetic_library(12);
  return shapes;
}

CollageSettings settings() {
  CollageSettings s;
  s.seed = 3;
  s.pieces.min_scale_px = 20;
  s.pieces.max_scale_px = 90;
  return s;
}

class CollagePool : public testing::Test {
 protected:
  static constexpr int kRounds = 10;

  test::RoundsByHand rounds_{make_rectangle_canvas(300, 220), settings(), library()};
  Collage& collage_ = rounds_.collage();
};

Edges edges_of(const std::vector<PooledSample>& pool) {
  Edges edges;
  for (const PooledSample& sample : pool) edges.insert(sample.edge);
  return edges;
}

/// Its candidates were found for another neighbourhood.
TEST_F(CollagePool, ASampleThatIsRenewedLosesItsCandidatesAndIsMatchedAgain) {
  int renewed = 0;
  Candidate best;
  for (int round = 0; round < kRounds && rounds_.choose(best); ++round) {
    const Edges pooled_before = edges_of(rounds_.state().pool);
    const Window changed = collage_.place(best);
    const CheckpointState after = rounds_.state();
    const Edges pooled = edges_of(after.pool);
    for (const std::uint32_t edge : after.stale) {
      EXPECT_FALSE(pooled.contains(edge)) << edge;
      renewed += pooled_before.contains(edge);
    }
    collage_.rescore(changed, rounds_.measure(changed));
  }
  EXPECT_GT(renewed, 20) << "the test needs samples that had candidates";
}

using Name = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;  // edge, shape, source

std::map<Name, Candidate> candidates_by_name(const CheckpointState& state) {
  std::map<Name, Candidate> result;
  for (const PooledSample& sample : state.pool) {
    for (const Candidate& c : sample.candidates) result[{sample.edge, c.shape, c.source}] = c;
  }
  return result;
}

/// The exact areas belong to the field before.
TEST_F(CollagePool, WhatIsMeasuredAgainIsScoredAgainAndCheckedAgain) {
  int exact_before = 0;
  Candidate best;
  for (int round = 0; round < kRounds && rounds_.choose(best); ++round) {
    const Window changed = collage_.place(best);
    const std::map<Name, Candidate> before = candidates_by_name(rounds_.state());
    const std::vector<Docking> touched = collage_.touched_by(changed);
    const std::vector<DockingTerms> terms = rounds_.measure(changed);
    std::map<Name, DockingTerms> measured;
    for (std::size_t i = 0; i < touched.size(); ++i) {
      measured[{touched[i].sample, touched[i].shape, touched[i].source}] = terms[i];
    }
    collage_.rescore(changed, terms);
    for (const auto& [name, c] : candidates_by_name(rounds_.state())) {
      const Candidate& then = before.at(name);
      if (!measured.contains(name)) {
        EXPECT_EQ(c.exact, then.exact);
        EXPECT_EQ(c.score, then.score);
        continue;
      }
      exact_before += then.exact;
      EXPECT_FALSE(c.exact);
      EXPECT_EQ(c.terms, measured[name]);
      const float scale = c.canvas_from_shape.scale();
      const PieceSize size{scale, c.perimeter * scale, rounds_.context().max_scale_px};
      EXPECT_EQ(c.score, objective(c.terms, size, settings().objective));
    }
  }
  EXPECT_GT(exact_before, 2) << "the test needs candidates that were checked exactly";
}

/// Those with one or none left are matched again where there were more to begin with; two are enough.
TEST_F(CollagePool, ASampleIsMatchedAgainWhenItHasLessThanTwoLeftAndThereWereMore) {
  std::map<std::size_t, int> seen;  // samples that lost some, by what they have left
  Candidate best;
  for (int round = 0; round < kRounds && rounds_.choose(best); ++round) {
    const Window changed = collage_.place(best);
    const CheckpointState before = rounds_.state();
    std::vector<DockingTerms> terms = rounds_.measure(changed);
    for (std::size_t i = 0; i < terms.size(); i += 2) terms[i].overlap_px2 = 1e9f;  // every other one is given up
    collage_.rescore(changed, terms);
    const CheckpointState after = rounds_.state();
    Edges expected(before.stale.begin(), before.stale.end());
    ASSERT_EQ(after.pool.size(), before.pool.size());
    for (std::size_t i = 0; i < after.pool.size(); ++i) {
      const std::size_t left = after.pool[i].candidates.size();
      if (left == before.pool[i].candidates.size()) continue;
      ++seen[left];
      if (left < 2 && after.pool[i].truncated) expected.insert(after.pool[i].edge);
    }
    EXPECT_EQ(Edges(after.stale.begin(), after.stale.end()), expected);
  }
  for (const std::size_t left : {0, 1, 2}) EXPECT_GT(seen[left], 0) << left;
}

}  // namespace
}  // namespace tessera::master
