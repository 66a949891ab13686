// Whole collages of synthetic shapes, with the plain C++ matcher.
#include <gtest/gtest.h>

#include "core/collage/exact_terms.h"
#include "core/collage/objective.h"
#include "core/collage/quality.h"
#include "core/matching/docking_terms.h"
#include "core/tuning.h"
#include "master/collage.h"
#include "master/collage_loop.h"
#include "support/divided_matcher.h"
#include "support/polygon_distance.h"

namespace tessera::master {
namespace {

const std::vector<Shape>& library() {
  static const std::vector<Shape> shapes = test::synthetic_library(12);
  return shapes;
}

CollageSettings settings() {
  CollageSettings s;
  s.seed = 3;
  s.pieces.min_scale_px = 20;
  s.pieces.max_scale_px = 90;
  s.match.tangent_dockings = 150;
  return s;
}

/// The library divided at `cuts`.
CollageResult run(const Canvas& canvas, const CollageSettings& s, std::vector<std::uint32_t> cuts,
                  Observer& observer) {
  const MatchingContext context = make_matching_context(s, std::uint32_t(library().size()));
  CompositeMatcher matcher = test::divided_matcher(library(), context, std::move(cuts));
  test::VectorShapes shapes(library());
  return make_collage(canvas, s, matcher, shapes, observer);
}

CollageResult run(const Canvas& canvas, const CollageSettings& s, std::vector<std::uint32_t> cuts = {}) {
  SilentObserver silent;
  return run(canvas, s, std::move(cuts), silent);
}

Quality quality(const Canvas& canvas, const CollageResult& result) {
  return measure_quality(canvas, result.placements, [](ShapeId id) -> const Shape& { return library()[index_of(id)]; });
}

TEST(Collage, FillsTheCanvasWithoutOverlap) {
  const Canvas canvas = make_rectangle_canvas(300, 220);
  const CollageResult result = run(canvas, settings());
  const Quality q = quality(canvas, result);
  EXPECT_GT(q.coverage, 0.78);
  EXPECT_LT(q.overlap, 0.006);
  EXPECT_LT(q.outside, 0.001);
  EXPECT_GT(q.shared_boundary, 0.4);
  EXPECT_EQ(result.statistics.stopped_by, "full");
  for (const Placement& p : result.placements) {
    EXPECT_GE(p.canvas_from_shape.scale(), 20.f);
    EXPECT_LE(p.canvas_from_shape.scale(), 90.1f);
  }
}

TEST(Collage, DoesNotDependOnHowTheLibraryIsDivided) {
  const Canvas canvas = make_rectangle_canvas(240, 160);
  const auto whole = run(canvas, settings()).placements;
  ASSERT_GT(whole.size(), 5u);
  EXPECT_EQ(run(canvas, settings(), {5}).placements, whole);
  EXPECT_EQ(run(canvas, settings(), {1, 2, 9}).placements, whole);
  EXPECT_EQ(run(canvas, settings(), {4, 4}).placements, whole) << "one part without shapes";
}

TEST(Collage, IsTheSameFromRunToRunAndAnotherWithAnotherSeed) {
  const Canvas canvas = make_rectangle_canvas(240, 160);
  CollageSettings s = settings();
  s.stop.pieces = 8;
  const auto first = run(canvas, s).placements;
  EXPECT_EQ(run(canvas, s).placements, first);
  s.seed = 4;
  EXPECT_NE(run(canvas, s).placements, first);
}

TEST(Collage, FillsARegionWithAHole) {
  Grid<float> coverage(600, 600);
  for (int y = 0; y < 600; ++y) {
    for (int x = 0; x < 600; ++x) {
      const float r = std::hypot(float(x) - 300, float(y) - 300);
      coverage(x, y) = r < 290 && r > 90;
    }
  }
  const Canvas canvas = make_mask_canvas(coverage);
  const Quality q = quality(canvas, run(canvas, settings()));
  EXPECT_GT(q.coverage, 0.7);
  EXPECT_LT(q.outside, 0.003);
}

TEST(Collage, RespectsUsesRotationAndPieces) {
  const Canvas canvas = make_rectangle_canvas(300, 220);
  CollageSettings s = settings();
  s.pieces.uses = 1;
  s.pieces.min_rotation_rad = -0.3f;
  s.pieces.max_rotation_rad = 0.3f;
  const CollageResult once = run(canvas, s);
  std::vector<int> uses(library().size());
  for (const Placement& p : once.placements) {
    EXPECT_EQ(++uses[index_of(p.shape)], 1);
    EXPECT_LE(std::abs(p.canvas_from_shape.rotation_rad()), 0.301f);
  }
  EXPECT_GT(once.placements.size(), 4u);
  s.stop.pieces = 3;
  const CollageResult three = run(canvas, s);
  EXPECT_EQ(three.placements.size(), 3u);
  EXPECT_EQ(three.statistics.stopped_by, "pieces");
}

/// One angle for all: the search must be easier, not empty.
TEST(Collage, FillsWithUprightPieces) {
  const Canvas canvas = make_rectangle_canvas(300, 220);
  for (const float angle_rad : {0.f, 1.5707964f}) {
    CollageSettings s = settings();
    s.pieces.min_rotation_rad = s.pieces.max_rotation_rad = angle_rad;
    const CollageResult result = run(canvas, s);
    EXPECT_GT(quality(canvas, result).coverage, 0.7);
    for (const Placement& p : result.placements) EXPECT_NEAR(p.canvas_from_shape.rotation_rad(), angle_rad, 1e-5f);
  }
}

TEST(Collage, FillsWithPiecesOfNearlyOneSize) {
  const Canvas canvas = make_rectangle_canvas(300, 220);
  CollageSettings s = settings();
  s.pieces.min_scale_px = 40;
  s.pieces.max_scale_px = 40.4f;
  const CollageResult result = run(canvas, s);
  EXPECT_GT(quality(canvas, result).coverage, 0.45);
  EXPECT_GT(result.statistics.pads_per_shape, 0);
}

/// As written: with three decimals.
std::vector<Outline> written_outlines(const std::vector<Placement>& placements) {
  std::vector<Outline> outlines;
  for (const Placement& placement : placements) {
    Outline outline = library()[index_of(placement.shape)].outline;
    for (std::vector<Vec2>& curve : outline.curves) {
      for (Vec2& p : curve) {
        p = placement.canvas_from_shape.apply(p);
        p = {std::round(p.x * 1000) / 1000, std::round(p.y * 1000) / 1000};
      }
    }
    outlines.push_back(outline);
  }
  return outlines;
}

/// Between two of the pieces, or one of them and the edge of a rectangle, px.
double least_distance_px(const Canvas& canvas, const std::vector<Placement>& placements) {
  const std::vector<Outline> outlines = written_outlines(placements);
  double least = 1e9;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    for (const Vec2 p : outlines[i].curves[0]) {
      least = std::min({least, double(p.x), double(p.y), double(canvas.width_px) - p.x, double(canvas.height_px) - p.y});
    }
    const Similarity& a = placements[i].canvas_from_shape;
    for (std::size_t k = 0; k < i; ++k) {
      const Similarity& b = placements[k].canvas_from_shape;
      const float radii_px = library()[index_of(placements[i].shape)].radius * a.scale() + library()[index_of(placements[k].shape)].radius * b.scale();
      if (norm(a.translation() - b.translation()) > radii_px + 8) continue;
      least = std::min(least, test::polygon_distance(outlines[i], outlines[k]));
    }
  }
  return least;
}

TEST(Collage, KeepsThePadding) {
  const Canvas canvas = make_rectangle_canvas(240, 160);
  for (const float padding_px : {1.f, 2.f, 3.f, 7.f}) {
    CollageSettings s = settings();
    s.pieces.padding_px = padding_px;
    const CollageResult result = run(canvas, s);
    EXPECT_GE(least_distance_px(canvas, result.placements), padding_px);
    EXPECT_GT(quality(canvas, result).coverage, padding_px < 4 ? 0.5 : 0.3);
  }
}

TEST(Collage, KeepsThePaddingWithAnySizesAndRotations) {
  const Canvas canvas = make_rectangle_canvas(160, 120);
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    CollageSettings s = settings();
    s.seed = seed;
    s.pieces.padding_px = 3;
    s.pieces.max_scale_px = 16 * float(seed) + 40;
    s.pieces.min_scale_px = s.pieces.max_scale_px / (seed % 2 ? 8 : 2);
    if (seed > 2) s.pieces.min_rotation_rad = s.pieces.max_rotation_rad = 0;
    EXPECT_GE(least_distance_px(canvas, run(canvas, s).placements), 3.0) << "seed " << seed;
  }
}

/// However thin a tip is, no vertex of a piece lies deep in another.
TEST(Collage, NoVertexLiesDeepInAnotherPiece) {
  const Canvas canvas = make_rectangle_canvas(300, 220);
  const std::vector<Placement> placements = run(canvas, settings()).placements;
  const std::vector<Outline> outlines = written_outlines(placements);
  float deepest = 0;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    for (std::size_t k = 0; k < outlines.size(); ++k) {
      const Vec2 apart = placements[i].canvas_from_shape.translation() - placements[k].canvas_from_shape.translation();
      if (i == k || norm(apart) > 150) continue;
      for (const Vec2 p : outlines[i].curves[0]) deepest = std::max(deepest, -test::signed_distance(outlines[k], p));
    }
  }
  EXPECT_LE(deepest, kHardDepth_px + 0.01f);
}

TEST(Collage, WithoutTangentDockingsHasNone) {
  CollageSettings s = settings();
  s.match.tangent_dockings = 0;
  Canvas canvas = make_rectangle_canvas(300, 220);
  FreeField seeded(canvas, s.pieces);  // a rectangle alone has no PADs
  seeded.stamp(library()[4], {90, 0, 150, 110});
  canvas.distance = seeded.field();
  const CollageResult result = run(canvas, s);
  const RunStatistics& statistics = result.statistics;
  EXPECT_GT(result.placements.size(), 2u);
  EXPECT_EQ(statistics.stopped_by, "full");
  EXPECT_EQ(statistics.docking_choices,
            statistics.target_samples * statistics.shapes * std::uint64_t(statistics.pads_per_shape));
}

TEST(Collage, WithoutSettlingPlacesWhatMatchingFound) {
  CollageSettings s = settings();
  s.stop.pieces = 1;
  s.settle = false;
  const Canvas canvas = make_rectangle_canvas(240, 160);
  const std::vector<Placement> as_found = run(canvas, s).placements;
  s.settle = true;
  const std::vector<Placement> settled = run(canvas, s).placements;
  ASSERT_EQ(as_found.size(), 1u);
  EXPECT_EQ(as_found[0].shape, settled[0].shape);
  EXPECT_LT(as_found[0].canvas_from_shape.scale(), settled[0].canvas_from_shape.scale()) << "only settling grows";
}

TEST(Collage, StopsWhenAsked) {
  class StopAfter : public SilentObserver {
   public:
    void progressed(const Progress& progress) override { pieces = progress.pieces; }
    const char* stop_requested() override { return pieces >= 4 ? "signal" : nullptr; }
    std::size_t pieces = 0;
  };
  StopAfter observer;
  const CollageResult result = run(make_rectangle_canvas(240, 160), settings(), {}, observer);
  EXPECT_EQ(result.placements.size(), 4u);
  EXPECT_EQ(result.statistics.stopped_by, "signal");
  EXPECT_TRUE(result.unfinished);
}

TEST(Collage, OfACanvasWithoutAreaIsEmpty) {
  const CollageResult result = run(make_mask_canvas(Grid<float>(100, 80, 0.f)), settings());
  EXPECT_TRUE(result.placements.empty());
}

CollageSettings improved(int trials) {
  CollageSettings s = settings();
  s.improve.trials = trials;
  return s;
}

TEST(Collage, ImprovingCoversMoreAndKeepsTheRules) {
  const Canvas canvas = make_rectangle_canvas(300, 220);
  const Quality before = quality(canvas, run(canvas, settings()));
  const CollageResult result = run(canvas, improved(40));
  const Quality after = quality(canvas, result);
  EXPECT_EQ(result.statistics.trials, 40u);
  EXPECT_GT(result.statistics.trials_kept, 2u);
  EXPECT_GT(after.coverage, before.coverage + 0.003);
  EXPECT_LT(after.overlap, 0.01);
  EXPECT_LT(after.outside, 0.001);
}

TEST(Collage, ImprovingDoesNotDependOnHowTheLibraryIsDivided) {
  const Canvas canvas = make_rectangle_canvas(240, 160);
  const CollageResult whole = run(canvas, improved(15));
  EXPECT_GT(whole.statistics.trials_kept, 0u);
  EXPECT_EQ(run(canvas, improved(15), {1, 2, 9}).placements, whole.placements);
}

TEST(Collage, ImprovingKeepsToTheNumberOfUses) {
  CollageSettings s = improved(20);
  s.pieces.uses = 2;
  std::map<ShapeId, int> uses;
  const CollageResult result = run(make_rectangle_canvas(300, 220), s);
  EXPECT_GT(result.statistics.trials_kept, 0u);
  for (const Placement& p : result.placements) EXPECT_LE(++uses[p.shape], 2);
}

/// Rounds by hand, with or without checking ahead while the matcher would count.
std::vector<Placement> placed_in_rounds(int rounds, bool checking_ahead) {
  const CollageSettings s = settings();
  const MatchingContext context = make_matching_context(s, std::uint32_t(library().size()));
  CompositeMatcher matcher = test::divided_matcher(library(), context, {});
  test::VectorShapes shapes(library());
  Collage collage(make_rectangle_canvas(300, 220), s, context, shapes);
  const CanvasField& field = collage.free().field();
  matcher.start_field(field.value.width(), field.value.height(), field.origin);
  RunStatistics statistics;
  PairReach reach;
  for (int round = 0; round < rounds; ++round) {
    matcher.update_field(read_patch(field.value, field.value.bounds()));
    const std::vector<TargetSample> samples = collage.take_stale_samples();
    int calls = 0;
    const MatchRound found = match(matcher, samples, {20, 150}, 1000, reach, statistics, [&] {
      ++calls;
      if (checking_ahead) collage.check_ahead();
    });
    EXPECT_EQ(calls, samples.empty() ? 0 : 1);
    collage.add_candidates(samples, found);
    if (checking_ahead) collage.check_ahead();
    Candidate best;
    if (!collage.choose(best)) break;
    const Window changed = collage.place(best);
    matcher.update_field(read_patch(field.value, field.value.bounds()));
    matcher.post_measure(collage.touched_by(changed));
    collage.rescore(changed, matcher.take_measure());
  }
  return collage.placements();
}

/// Settling moves, shrinks and grows a piece: what it is worth is what it is worth where it ends, by its exact areas.
TEST(Collage, ASettledPieceIsScoredWhereItEnds) {
  for (const Objective kind : {Objective::scale_aware, Objective::paper}) {
    CollageSettings s = settings();
    s.objective.kind = kind;
    const MatchingContext context = make_matching_context(s, std::uint32_t(library().size()));
    CompositeMatcher matcher = test::divided_matcher(library(), context, {});
    test::VectorShapes shapes(library());
    Collage collage(make_rectangle_canvas(300, 220), s, context, shapes);
    const CanvasField& field = collage.free().field();
    matcher.start_field(field.value.width(), field.value.height(), field.origin);
    RunStatistics statistics;
    PairReach reach;
    for (int round = 0; round < 8; ++round) {
      matcher.update_field(read_patch(field.value, field.value.bounds()));
      const std::vector<TargetSample> samples = collage.take_stale_samples();
      collage.add_candidates(samples, match(matcher, samples, {20, 150}, 1000, reach, statistics));
      Candidate best;
      ASSERT_TRUE(collage.choose(best));
      const Shape& shape = library()[index_of(best.shape)];
      const float scale = best.canvas_from_shape.scale();
      const OpenedField opened(collage.free(), s.pieces);
      const ExactAreas areas = exact_areas(shape, best.canvas_from_shape, collage.free(), opened, s.pieces);
      const PieceSize size{scale, best.perimeter * scale, s.pieces.max_scale_px};
      EXPECT_FLOAT_EQ(best.score, objective(with_exact_areas(best.terms, areas), size, s.objective));
      EXPECT_EQ(best.terms, docking_terms(best.canvas_from_shape, shapes.model(best.shape), collage.free().view(), context));
      const Window changed = collage.place(best);
      matcher.update_field(read_patch(field.value, field.value.bounds()));
      matcher.post_measure(collage.touched_by(changed));
      collage.rescore(changed, matcher.take_measure());
    }
  }
}

TEST(Collage, CheckingAheadChangesNothing) {
  const std::vector<Placement> expected = placed_in_rounds(14, false);
  EXPECT_GT(expected.size(), 10u);
  EXPECT_EQ(placed_in_rounds(14, true), expected);
}

/// The limits of [stop] hold while improving, too.
TEST(Collage, ImprovingKeepsToTheLimitsOfStop) {
  const Canvas canvas = make_rectangle_canvas(300, 220);
  const CollageResult greedy = run(canvas, settings());
  CollageSettings s = improved(60);
  const CollageResult free = run(canvas, s);
  ASSERT_GT(free.placements.size(), greedy.placements.size());
  EXPECT_EQ(free.statistics.rounds, greedy.statistics.rounds) << "the card's iterations are those of the greedy part";
  s.stop.pieces = int(greedy.placements.size()) + 1;
  EXPECT_LE(run(canvas, s).placements.size(), std::size_t(s.stop.pieces));
  s = improved(60);
  s.stop.coverage = float(quality(canvas, greedy).coverage) + 0.001f;
  const CollageResult covered = run(canvas, s);
  EXPECT_EQ(covered.statistics.stopped_by, "coverage");
  EXPECT_LT(covered.statistics.trials, 60u);
}

/// A collage that went there and back is as if it had never gone: the same field, the same samples.
TEST(Collage, PiecesTakenOutAndPutBackLeaveNoTrace) {
  const Canvas canvas = make_rectangle_canvas(300, 220);
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
  const Window all = canvas.distance.value.bounds();
  fresh.mark_stale(all);
  worn.mark_stale(all);
  const std::vector<TargetSample> expected = fresh.take_stale_samples();
  const std::vector<TargetSample> found = worn.take_stale_samples();
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_EQ(found[k].id, expected[k].id);
    EXPECT_EQ(found[k].position, expected[k].position);
    EXPECT_EQ(found[k].tangent, expected[k].tangent);
    EXPECT_EQ(found[k].pyramid, expected[k].pyramid);
  }
}

}  // namespace
}  // namespace tessera::master
