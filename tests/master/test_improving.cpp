// Improving as a part of the whole loop.
#include <gtest/gtest.h>

#include <map>

#include "core/base/stop.h"
#include "whole_collage.h"

namespace tessera::master {
namespace test_improving {

using namespace whole_collage;

TEST(Improving, CoversMoreAndKeepsTheRules) {
  const Canvas canvas = make_rectangle_canvas(300, 220);
  const Quality before = quality(canvas, run(canvas, settings()));
  const CollageResult result = run(canvas, improved(40));
  const Quality after = quality(canvas, result);
  EXPECT_EQ(result.statistics.trials, 40u);
  EXPECT_GE(result.statistics.trials_kept, 2u) << "all pieces moved, and some were replaced";
  EXPECT_GT(after.coverage, before.coverage + 0.003);
  EXPECT_LT(after.overlap, 0.01);
  EXPECT_LT(after.outside, 0.001);
}

TEST(Improving, DoesNotDependOnHowTheLibraryIsDivided) {
  const Canvas canvas = make_rectangle_canvas(240, 160);
  const CollageResult whole = run(canvas, improved(15));
  EXPECT_GT(whole.statistics.trials_kept, 0u);
  EXPECT_EQ(run(canvas, improved(15), {1, 2, 9}).placements, whole.placements);
}

TEST(Improving, KeepsToTheNumberOfUses) {
  CollageSettings s = improved(20);
  s.pieces.uses = 2;
  std::map<ShapeId, int> uses;
  const CollageResult result = run(make_rectangle_canvas(300, 220), s);
  EXPECT_GT(result.statistics.trials_kept, 0u);
  for (const Placement& p : result.placements) EXPECT_LE(++uses[p.shape], 2);
}

TEST(Improving, CoversMoreWherePiecesMoveTogether) {
  const Canvas canvas = make_rectangle_canvas(300, 220);
  CollageSettings s = improved(12);
  s.pieces.min_scale_px = 40;
  s.pieces.max_scale_px = 80;
  const double moving = quality(canvas, run(canvas, s)).coverage;
  s.improve.relax = false;
  EXPECT_GT(moving, quality(canvas, run(canvas, s)).coverage + 0.01);
}

/// Each piece keeps to the sizes and rotations of a stance, and given pieces do not move.
TEST(Improving, PiecesMoveWithinTheirPoses) {
  const Canvas canvas = make_rectangle_canvas(300, 220);
  CollageSettings s = improved(8);
  s.pieces.min_scale_px = 30;
  s.pieces.max_scale_px = 60;
  s.pieces.min_rotation_rad = -0.2f;
  s.pieces.max_rotation_rad = 0.3f;
  s.wishes.given = {{ShapeId{2}, {40, 0, 150, 110}, true}};
  const CollageResult result = run(canvas, s);
  EXPECT_GT(result.statistics.trials_kept, 0u);
  EXPECT_EQ(result.placements[0].canvas_from_shape, s.wishes.given[0].canvas_from_shape);
  for (const Placement& p : result.placements) {
    EXPECT_GE(p.canvas_from_shape.scale(), 30 * (1 - 1e-5f));
    EXPECT_LE(p.canvas_from_shape.scale(), 60 * (1 + 1e-5f));
    EXPECT_GE(p.canvas_from_shape.rotation_rad(), -0.2f - 1e-4f);
    EXPECT_LE(p.canvas_from_shape.rotation_rad(), 0.3f + 1e-4f);
  }
}

TEST(Improving, PiecesMoveTogetherAcrossASeam) {
  const Canvas canvas = make_seamless_canvas(300, 220, true, true);
  CollageSettings s = improved(12);
  s.pieces.min_scale_px = 40;
  s.pieces.max_scale_px = 80;
  const CollageResult result = run(canvas, s);
  EXPECT_GT(result.statistics.trials_kept, 0u);
  const Quality q = quality(canvas, result);
  EXPECT_LT(q.overlap, 0.01);
  s.improve.trials = 0;
  EXPECT_GT(q.coverage, quality(canvas, run(canvas, s)).coverage + 0.005);
}

/// The limits of [stop] also hold while improving.
TEST(Improving, KeepsToTheLimitsOfStop) {
  const Canvas canvas = make_rectangle_canvas(300, 220);
  const CollageResult greedy = run(canvas, settings());
  CollageSettings s = improved(60);
  s.stop.pieces = 1000;
  const CollageResult free = run(canvas, s);
  ASSERT_GT(free.placements.size(), greedy.placements.size());
  EXPECT_EQ(free.statistics.rounds, greedy.statistics.rounds) << "the card's iterations are those of the greedy part";
  s.stop.pieces = int(greedy.placements.size()) + 1;
  EXPECT_LE(run(canvas, s).placements.size(), std::size_t(s.stop.pieces));
  s = improved(60);
  s.stop.coverage = float(quality(canvas, greedy).coverage) + 0.001f;
  const CollageResult covered = run(canvas, s);
  EXPECT_EQ(covered.statistics.stopped_by, StopReason::coverage);
  EXPECT_LT(covered.statistics.trials, 60u);
}

}  // namespace test_improving
}  // namespace tessera::master
