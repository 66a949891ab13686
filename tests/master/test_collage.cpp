// Whole collages: the region is filled, the settings hold, and the library's division changes nothing.
#include <gtest/gtest.h>

#include "core/base/stop.h"
#include "core/field/free_field.h"
#include "whole_collage.h"

namespace tessera::master {
namespace test_collage {

using namespace whole_collage;

TEST(Collage, FillsTheCanvasWithoutOverlap) {
  const Canvas canvas = make_rectangle_canvas(300, 220);
  const CollageResult result = run(canvas, settings());
  const Quality q = quality(canvas, result);
  EXPECT_GT(q.coverage, 0.78);
  EXPECT_LT(q.overlap, 0.006);
  EXPECT_LT(q.outside, 0.001);
  EXPECT_GT(q.shared_boundary, 0.4);
  EXPECT_EQ(result.statistics.stopped_by, StopReason::full);
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
  EXPECT_EQ(three.statistics.stopped_by, StopReason::pieces);
}

/// With one angle for all, the search is easier, and must still find pieces.
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
  EXPECT_EQ(statistics.stopped_by, StopReason::full);
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
    std::optional<StopReason> stop_requested() override {
      return pieces >= 4 ? std::optional(StopReason::signal) : std::nullopt;
    }
    std::size_t pieces = 0;
  };
  StopAfter observer;
  const CollageResult result = run(make_rectangle_canvas(240, 160), settings(), {}, observer);
  EXPECT_EQ(result.placements.size(), 4u);
  EXPECT_EQ(result.statistics.stopped_by, StopReason::signal);
  EXPECT_TRUE(result.unfinished);
}

TEST(Collage, OfACanvasWithoutAreaIsEmpty) {
  const CollageResult result = run(make_mask_canvas(Grid<float>(100, 80, 0.f)), settings());
  EXPECT_TRUE(result.placements.empty());
}

}  // namespace test_collage
}  // namespace tessera::master
