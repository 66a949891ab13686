// Invariants of rounds: pieces are scored in their final pose, and computing ahead or undoing leaves no trace.
#include <gtest/gtest.h>

#include "core/collage/exact_terms.h"
#include "core/collage/objective.h"
#include "core/matching/docking_terms.h"
#include "master/collage.h"
#include "rounds_by_hand.h"
#include "whole_collage.h"

namespace tessera::master {
namespace test_rounds {

using namespace whole_collage;

/// A canvas with edges, and one without.
const std::vector<Canvas>& canvases() {
  static const std::vector<Canvas> both = {make_rectangle_canvas(300, 220), make_seamless_canvas(300, 220, true, true)};
  return both;
}

/// Runs rounds by hand, with or without checking ahead while the matcher docks.
std::vector<Placement> placed_in_rounds(const Canvas& canvas, int rounds, bool checking_ahead) {
  const CollageSettings s = settings();
  const MatchingContext context = make_matching_context(s, std::uint32_t(library().size()));
  CompositeMatcher matcher = test::divided_matcher(library(), context, {});
  test::VectorShapes shapes(library());
  Collage collage(canvas, s, context, shapes);
  const CanvasField& field = collage.free().field();
  matcher.start_field(field.value.width(), field.value.height(), field.origin);
  RunStatistics statistics;
  for (int round = 0; round < rounds; ++round) {
    matcher.update_field({read_patch(field.value, field.value.bounds())});
    const std::vector<TargetSample> samples = collage.schedule().take();
    int calls = 0;
    const MatchRound found = match(matcher, samples, {20, 150}, 1000, statistics, [&] {
      ++calls;
      if (checking_ahead) collage.check_ahead();
    });
    EXPECT_EQ(calls, samples.empty() ? 0 : 1);
    collage.add_candidates(samples, found);
    if (checking_ahead) collage.check_ahead();
    Candidate best;
    if (!collage.choose(best)) break;
    collage.place(best);
    matcher.update_field({read_patch(field.value, field.value.bounds())});
    collage.merge_batch();
    matcher.post_measure(collage.touched());
    collage.end_batch(matcher.take_measure());
  }
  return collage.placements();
}

/// A collage that goes on from the saved state has computed nothing ahead. It chooses the same, also within a batch.
TEST(Rounds, AChoiceFollowsFromTheSavedState) {
  CollageSettings s = settings();
  s.pieces.max_scale_px = 50;
  int compared = 0;
  for (const Canvas& canvas : canvases()) {
    test::RoundsByHand rounds(canvas, s, library());
    const auto choose = [&](Candidate& best) {
      test::RoundsByHand fresh(canvas, s, library());
      fresh.collage().restore(rounds.state());
      Candidate expected;
      const bool found = rounds.collage().choose(best);
      EXPECT_EQ(found, fresh.collage().choose(expected));
      EXPECT_EQ(best.canvas_from_shape, found ? expected.canvas_from_shape : best.canvas_from_shape);
      EXPECT_EQ(best.score, found ? expected.score : best.score);
      compared += found;
      return found;
    };
    Candidate best;
    for (int round = 0; round < 25 && rounds.choose(best); ++round) {
      do rounds.collage().place(best);
      while (choose(best));
      rounds.end_batch();
      choose(best);  // nothing is matched yet
    }
  }
  EXPECT_GT(compared, 40);
}

/// Settling moves, shrinks and grows a piece. Its score is that of its final pose, from its exact areas.
TEST(Rounds, ASettledPieceIsScoredWhereItEnds) {
  for (const Objective kind : {Objective::scale_aware, Objective::paper}) {
    CollageSettings s = settings();
    s.objective.kind = kind;
    test::RoundsByHand rounds(make_rectangle_canvas(300, 220), s, library());
    test::VectorShapes shapes(library());
    Collage& collage = rounds.collage();
    for (int round = 0; round < 8; ++round) {
      Candidate best;
      ASSERT_TRUE(rounds.choose(best));
      const Shape& shape = library()[index_of(best.shape)];
      const float scale = best.canvas_from_shape.scale();
      const OpenedField opened(collage.free(), s.pieces);
      const ExactAreas areas = exact_areas(shape, best.canvas_from_shape, collage.free(), opened, s.pieces);
      const PieceSize size{scale, best.perimeter * scale, s.pieces.max_scale_px};
      EXPECT_FLOAT_EQ(best.score, objective(with_exact_areas(best.terms, areas), size, s.objective));
      EXPECT_EQ(best.terms, docking_terms(best.canvas_from_shape, shapes.model(best.shape), collage.free().view(),
                                          rounds.context()));
      rounds.place(best);
    }
  }
}

TEST(Rounds, CheckingAheadChangesNothing) {
  for (const Canvas& canvas : canvases()) {
    const std::vector<Placement> expected = placed_in_rounds(canvas, 14, false);
    EXPECT_GT(expected.size(), 10u);
    EXPECT_EQ(placed_in_rounds(canvas, 14, true), expected);
  }
}

/// A piece also changes the scores of candidates across a seam.
/// Moving them into one period rounds their poses, which sometimes changes whether a boundary point counts as in contact.
TEST(Rounds, ASeamlessCollageMeasuresWhatEachPieceTouches) {
  test::RoundsByHand rounds(canvases()[1], settings(), library());
  test::VectorShapes shapes(library());
  Collage& collage = rounds.collage();
  int candidates = 0;
  int outdated = 0;
  Candidate best;
  for (int round = 0; round < 12 && rounds.choose(best); ++round) {
    rounds.place(best);
    for (const PooledSample& sample : rounds.state().pool) {
      for (const Candidate& c : sample.candidates) {
        const DockingTerms now =
            docking_terms(c.canvas_from_shape, shapes.model(c.shape), collage.free().view(), rounds.context());
        EXPECT_EQ(canvases()[1].period.wrapped(c.canvas_from_shape), c.canvas_from_shape);
        ++candidates;
        outdated +=
            std::abs(now.matched_px - c.terms.matched_px) > 2 || std::abs(now.overlap_px2 - c.terms.overlap_px2) > 5;
      }
    }
  }
  EXPECT_GT(candidates, 500);
  EXPECT_LE(outdated, candidates / 200);
}

/// A collage that changed and changed back has the same field and the same samples.
TEST(Rounds, PiecesTakenOutAndPutBackLeaveNoTrace) {
  for (const Canvas& canvas : canvases()) {
    const CollageSettings s = settings();
    const std::vector<Placement> placements = run(canvas, s).placements;
    test::VectorShapes shapes(library());
    const MatchingContext context = make_matching_context(s, std::uint32_t(library().size()));
    Collage fresh(canvas, s, context, shapes);
    fresh.replace_placements(placements);
    Collage worn(canvas, s, context, shapes);
    worn.replace_placements(placements);
    for (std::size_t i = 0; i < placements.size(); i += 3) {
      std::vector<Placement> fewer = placements;
      fewer.erase(fewer.begin() + std::ptrdiff_t(i));
      worn.replace_placements(fewer);
      worn.replace_placements(placements);
    }
    EXPECT_EQ(worn.free().free_256ths_px2(), fresh.free().free_256ths_px2());
    EXPECT_EQ(worn.free().field().value.data(), fresh.free().field().value.data());
    const Window all = fresh.free().grid().nodes();
    fresh.schedule().mark(all);
    worn.schedule().mark(all);
    const std::vector<TargetSample> expected = fresh.schedule().take();
    const std::vector<TargetSample> found = worn.schedule().take();
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_EQ(found[k].id, expected[k].id);
      EXPECT_EQ(found[k].position, expected[k].position);
      EXPECT_EQ(found[k].tangent, expected[k].tangent);
      EXPECT_EQ(found[k].pyramid, expected[k].pyramid);
    }
  }
}

}  // namespace test_rounds
}  // namespace tessera::master
