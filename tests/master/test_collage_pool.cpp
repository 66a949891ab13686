// The pool's candidates when a piece is placed beside them.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "core/collage/objective.h"
#include "core/settings/tuning.h"
#include "offering_matcher.h"
#include "rounds_by_hand.h"
#include "whole_collage.h"

namespace tessera::master {
namespace test_collage_pool {

using namespace whole_collage;

using Samples = std::set<SampleId>;

/// Settings with large pieces first: a few rounds touch many candidates, and some of these are checked exactly.
CollageSettings contrasting() {
  CollageSettings s = settings();
  s.objective.balance = 0;
  return s;
}

class CollagePool : public testing::Test {
 protected:
  static constexpr int kRounds = 10;

  test::RoundsByHand rounds_{make_rectangle_canvas(300, 220), contrasting(), library()};
  Collage& collage_ = rounds_.collage();
};

Samples samples_of(const std::vector<PooledSample>& pool) {
  Samples samples;
  for (const PooledSample& sample : pool) samples.insert(sample.id);
  return samples;
}

/// The sample's candidates were found for another neighbourhood.
TEST_F(CollagePool, ASampleThatIsRenewedLosesItsCandidatesAndIsMatchedAgain) {
  int renewed = 0;
  Candidate best;
  for (int round = 0; round < kRounds && rounds_.choose(best); ++round) {
    const Samples pooled_before = samples_of(rounds_.state().pool);
    collage_.place(best);
    collage_.merge_batch();
    const CheckpointState after = rounds_.state();
    const Samples pooled = samples_of(after.pool);
    for (const SampleId id : after.stale) {
      EXPECT_FALSE(pooled.contains(id)) << edge_number(id);
      renewed += pooled_before.contains(id);
    }
    collage_.end_batch(rounds_.measure());
  }
  EXPECT_GT(renewed, 20) << "the test needs samples that had candidates";
}

/// A refined docking as the matcher reports it, with the fraction `matched` of the boundary matched.
RefinedDocking found_at(ShapeId shape, float scale_px, Vec2 centre, float matched) {
  Docking docking;
  docking.shape = shape;
  docking.canvas_from_shape = {scale_px, 0, centre.x, centre.y};
  const Shape& s = library()[index_of(shape)];
  DockingTerms terms;
  terms.matched_px = matched * s.perimeter * scale_px;
  return {docking, terms, true, Extent{-80, -80, 300, 220}, s.perimeter, s.radius};
}

/// The first candidate lies outside the canvas, where no push can make it clear.
TEST_F(CollagePool, WhatCannotBeMadeClearIsGivenUpForTheNextBest) {
  CollageSettings s = settings();
  s.objective.overlap_weight = 0;
  test::RoundsByHand rounds(make_rectangle_canvas(300, 220), s, library());
  const std::vector<TargetSample> all = rounds.collage().schedule().take();
  MatchRound round;
  round.refined = {found_at(ShapeId{3}, 21, {-60, -60}, 1),
                   found_at(ShapeId{4}, 40, test::centre_at_upper_left(library()[4], 40), 0.2f)};
  round.truncated = {false};
  rounds.collage().add_candidates({all.front()}, round);
  Candidate best;
  ASSERT_TRUE(rounds.collage().choose(best));
  EXPECT_EQ(best.shape, ShapeId{4});
  std::size_t left = 0;
  for (const PooledSample& sample : rounds.state().pool) left += sample.candidates.size();
  EXPECT_EQ(left, 1u) << "the first one is not tried again";
}

TEST_F(CollagePool, ASampleThatIsGoneIsNotMatchedAgain) {
  Candidate best;
  for (int round = 0; round < kRounds && rounds_.choose(best); ++round) {
    collage_.schedule().mark(collage_.free().field().value.bounds());
    rounds_.place(best);
    EXPECT_EQ(rounds_.state().stale.size(), collage_.open_samples());
  }
}

TEST_F(CollagePool, WhatTouchesTooLittleOrOverlapsTooMuchDoesNotEnter) {
  const TargetSample sample = collage_.schedule().take().front();
  const auto enters = [&](float matched, float overlap) {
    MatchRound round;
    round.refined = {found_at(ShapeId{4}, 40, {150, 110}, matched)};
    round.refined[0].terms.overlap_px2 = overlap * 40 * 40;
    round.truncated = {false};
    collage_.add_candidates({sample}, round);
    return !rounds_.state().pool.front().candidates.empty();
  };
  EXPECT_TRUE(enters(1.01f * kLeastMatched, 0));
  EXPECT_FALSE(enters(0.99f * kLeastMatched, 0));
  EXPECT_TRUE(enters(0.5f, 0.99f * kMaxOverlap));
  EXPECT_FALSE(enters(0.5f, 1.01f * kMaxOverlap));
}

/// Shape, source and place. No two candidates have the same name.
using Name = std::tuple<ShapeId, std::uint32_t, float, float>;

Name name_of(ShapeId shape, std::uint32_t source, const Similarity& pose) { return {shape, source, pose.tx, pose.ty}; }

std::map<Name, Candidate> candidates_by_name(const CheckpointState& state) {
  std::map<Name, Candidate> result;
  for (const PooledSample& sample : state.pool) {
    for (const Candidate& c : sample.candidates) result[name_of(c.shape, c.source, c.canvas_from_shape)] = c;
  }
  return result;
}

/// The exact areas belong to the earlier field.
TEST_F(CollagePool, WhatIsMeasuredAgainIsScoredAgainAndCheckedAgain) {
  int exact_before = 0;
  Candidate best;
  for (int round = 0; round < kRounds && rounds_.choose(best); ++round) {
    collage_.place(best);
    collage_.merge_batch();
    const std::map<Name, Candidate> before = candidates_by_name(rounds_.state());
    const std::vector<Docking> touched = collage_.touched();
    const std::vector<DockingTerms> terms = rounds_.measure(touched);
    std::map<Name, DockingTerms> measured;
    for (std::size_t i = 0; i < touched.size(); ++i) {
      measured[name_of(touched[i].shape, touched[i].source, touched[i].canvas_from_shape)] = terms[i];
    }
    collage_.end_batch(terms);
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
      EXPECT_EQ(c.score, objective(c.terms, size, contrasting().objective));
    }
  }
  EXPECT_GT(exact_before, 2) << "the test needs candidates that were checked exactly";
}

/// The windows of the candidates are large enough.
TEST_F(CollagePool, WhatIsNotTouchedIsStillTrue) {
  std::size_t untouched = 0;
  Candidate best;
  for (int round = 0; round < kRounds && rounds_.choose(best); ++round) {
    collage_.place(best);
    collage_.merge_batch();
    const std::size_t touched = collage_.touched().size();
    collage_.end_batch(rounds_.measure());
    std::vector<Docking> all;
    std::vector<DockingTerms> expected;
    for (const PooledSample& sample : rounds_.state().pool) {
      for (const Candidate& c : sample.candidates) {
        all.push_back({0, c.shape, c.source, c.stance, 0, c.canvas_from_shape});
        expected.push_back(c.terms);
      }
    }
    untouched += all.size() - std::min(all.size(), touched);
    EXPECT_EQ(rounds_.measure(all), expected);
  }
  EXPECT_GT(untouched, 20u);
}

/// A sample with at most one candidate left is matched again if it had more matches than were listed. Two are enough.
TEST_F(CollagePool, ASampleIsMatchedAgainWhenItHasLessThanTwoLeftAndThereWereMore) {
  std::map<std::size_t, int> seen;  // the samples that lost candidates, by the number left
  Candidate best;
  for (int round = 0; round < kRounds && rounds_.choose(best); ++round) {
    collage_.place(best);
    collage_.merge_batch();
    const CheckpointState before = rounds_.state();
    std::vector<DockingTerms> terms = rounds_.measure();
    for (std::size_t i = 0; i < terms.size(); i += 2) terms[i].overlap_px2 = 1e9f;  // gives up every other candidate
    collage_.end_batch(terms);
    const CheckpointState after = rounds_.state();
    Samples expected(before.stale.begin(), before.stale.end());
    ASSERT_EQ(after.pool.size(), before.pool.size());
    for (std::size_t i = 0; i < after.pool.size(); ++i) {
      const std::size_t left = after.pool[i].candidates.size();
      if (left == before.pool[i].candidates.size()) continue;
      ++seen[left];
      if (left < 2 && after.pool[i].truncated) expected.insert(after.pool[i].id);
    }
    EXPECT_EQ(Samples(after.stale.begin(), after.stale.end()), expected);
  }
  for (const std::size_t left : {0, 1, 2}) EXPECT_GT(seen[left], 0) << left;
}

}  // namespace test_collage_pool
}  // namespace tessera::master
