// The distances of pieces to each other and to the canvas' edge, measured on the written outlines.
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "core/settings/tuning.h"
#include "support/polygon_distance.h"
#include "whole_collage.h"

namespace tessera::master {
namespace test_distances {

using namespace whole_collage;

/// The outlines as written, with three decimals.
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

/// The least distance between two pieces, or between a piece and the edge of a rectangle, in px.
double least_distance_px(const Canvas& canvas, const std::vector<Placement>& placements) {
  const std::vector<Outline> outlines = written_outlines(placements);
  double least = 1e9;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    for (const Vec2 p : outlines[i].curves[0]) {
      least = std::min({least, double(p.x), double(p.y)});
      least = std::min({least, double(canvas.width_px) - p.x, double(canvas.height_px) - p.y});
    }
    const Similarity& a = placements[i].canvas_from_shape;
    for (std::size_t k = 0; k < i; ++k) {
      const Similarity& b = placements[k].canvas_from_shape;
      const float radii_px = library()[index_of(placements[i].shape)].radius * a.scale() +
                             library()[index_of(placements[k].shape)].radius * b.scale();
      if (norm(a.translation() - b.translation()) > radii_px + 8) continue;
      least = std::min(least, test::polygon_distance(outlines[i], outlines[k]));
    }
  }
  return least;
}

/// Runs `check` with the tests' settings for the seeds 1 to `seeds`.
void for_seeds(std::uint64_t seeds, const std::function<void(CollageSettings)>& check) {
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    CollageSettings s = settings();
    s.seed = seed;
    check(s);
  }
}

TEST(Distances, KeepsThePadding) {
  const Canvas canvas = make_rectangle_canvas(240, 160);
  for (const float padding_px : {1.f, 2.f, 3.f, 7.f}) {
    CollageSettings s = settings();
    s.pieces.padding_px = padding_px;
    const CollageResult result = run(canvas, s);
    EXPECT_GE(least_distance_px(canvas, result.placements), padding_px);
    EXPECT_GT(quality(canvas, result).coverage, padding_px < 4 ? 0.5 : 0.3);
  }
}

TEST(Distances, KeepsThePaddingWithAnySizesAndRotations) {
  const Canvas canvas = make_rectangle_canvas(160, 120);
  for_seeds(4, [&](CollageSettings s) {
    s.pieces.padding_px = 3;
    s.pieces.max_scale_px = 16 * float(s.seed) + 40;
    s.pieces.min_scale_px = s.pieces.max_scale_px / (s.seed % 2 ? 8 : 2);
    if (s.seed > 2) s.pieces.min_rotation_rad = s.pieces.max_rotation_rad = 0;
    EXPECT_GE(least_distance_px(canvas, run(canvas, s).placements), 3.0);
  });
}

/// The largest depth of a piece's vertex in another piece, in px; negative if there is none.
float deepest_vertex_px(const std::vector<Placement>& placements) {
  const std::vector<Outline> outlines = written_outlines(placements);
  float deepest = -1e9f;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    for (std::size_t k = 0; k < outlines.size(); ++k) {
      const Vec2 apart = placements[i].canvas_from_shape.translation() - placements[k].canvas_from_shape.translation();
      if (i == k || norm(apart) > 150) continue;
      for (const Vec2 p : outlines[i].curves[0]) deepest = std::max(deepest, -test::signed_distance(outlines[k], p));
    }
  }
  return deepest;
}

/// However thin a tip is, no vertex of a piece lies deeper in another piece than allowed.
TEST(Distances, NoVertexLiesDeepInAnotherPiece) {
  const Canvas canvas = make_rectangle_canvas(300, 220);
  EXPECT_LE(deepest_vertex_px(run(canvas, settings()).placements), PieceSettings().overlap_px + 0.01f);
  CollageSettings little = settings();
  little.pieces.overlap_px = 0.5f;
  const float deepest_px = deepest_vertex_px(run(canvas, little).placements);
  EXPECT_LE(deepest_px, 0.51f);
  EXPECT_GT(deepest_px, 0.25f) << "what is allowed is not used";
}

TEST(Distances, WithoutOverlapNoPieceReachesIntoAnother) {
  const Canvas canvas = make_rectangle_canvas(240, 160);
  for_seeds(3, [&](CollageSettings s) {
    s.pieces.overlap_px = 0;
    const CollageResult result = run(canvas, s);
    EXPECT_LE(deepest_vertex_px(result.placements), 0.002f);
    EXPECT_GE(least_distance_px(canvas, result.placements), 0) << "beyond the edge";
    EXPECT_GT(quality(canvas, result).coverage, 0.6);
    EXPECT_LT(quality(canvas, result).overlap, 1e-4);
  });
}

/// Relaxation keeps the same rules as placing.
TEST(Distances, HoldAfterPiecesMovedTogether) {
  const Canvas canvas = make_rectangle_canvas(240, 160);
  for_seeds(2, [&](CollageSettings s) {
    s.improve.trials = 6;
    const CollageResult touching = run(canvas, s);
    EXPECT_GT(touching.statistics.trials_kept, 0u);
    EXPECT_LE(deepest_vertex_px(touching.placements), s.pieces.overlap_px + 0.01f);
    s.pieces.overlap_px = 0;
    const CollageResult apart = run(canvas, s);
    EXPECT_GT(apart.statistics.trials_kept, 0u);
    EXPECT_LE(deepest_vertex_px(apart.placements), 0.002f);
    s.pieces.padding_px = 3;
    const CollageResult padded = run(canvas, s);
    EXPECT_GT(padded.statistics.trials_kept, 0u);
    EXPECT_GE(least_distance_px(canvas, padded.placements), 3);
  });
}

/// All pieces have one size and lie close to pieces that do not move in a trial. One piece is given.
TEST(Distances, HoldBesidePiecesThatDoNotMove) {
  const Canvas canvas = make_rectangle_canvas(240, 160);
  for_seeds(3, [&](CollageSettings s) {
    s.pieces.padding_px = 3;
    s.pieces.min_scale_px = s.pieces.max_scale_px = 30;
    s.wishes.given = {{ShapeId{1}, {30, 0, 120, 80}, true}};
    s.improve.trials = 24;
    const CollageResult result = run(canvas, s);
    EXPECT_EQ(result.placements[0].canvas_from_shape, s.wishes.given[0].canvas_from_shape);
    EXPECT_GE(least_distance_px(canvas, result.placements), 3);
  });
}

/// The lines are thinner than the overlap allowed for pieces, but they must not lie on one another.
TEST(Distances, LinesDoNotLieOnLines) {
  const std::vector<Shape> rings{test::make_test_shape("ring", test::ring_outline(0.96f))};
  CollageSettings s = settings();
  s.pieces.min_scale_px = 15;
  s.pieces.max_scale_px = 60;
  s.stop.pieces = 60;
  const MatchingContext context = make_matching_context(s, 1);
  CompositeMatcher matcher = test::divided_matcher(rings, context, {});
  test::VectorShapes shapes(rings);
  SilentObserver silent;
  const Canvas canvas = make_rectangle_canvas(300, 220);
  const CollageResult result = make_collage(canvas, s, matcher, shapes, silent);
  EXPECT_GT(result.placements.size(), 5u);
  const Quality q = measure_quality(canvas, result.placements, [&](ShapeId) -> const Shape& { return rings[0]; });
  EXPECT_LT(q.overlap, 0.02);
}

}  // namespace test_distances
}  // namespace tessera::master
