// The starts of collages: keep-out zones, pieces of an earlier result, and growth from placed pieces. Each is also tested with
// interruptions.
#include <gtest/gtest.h>

#include <array>

#include "core/base/stop.h"
#include "core/field/field_lookup.h"
#include "core/field/keep_out.h"
#include "core/matching/sized_settings.h"
#include "interrupted_collage.h"
#include "master/collage.h"
#include "master/rules/outward_growth.h"
#include "support/input_error.h"
#include "whole_collage.h"

namespace tessera::master {
namespace test_start {

using namespace whole_collage;

const KeepOutRectangle kTitle{{120, 80}, {60, 20}, {1, 0}, 8};

Canvas with_title(Canvas canvas) {
  take_out(distance_to({kTitle}, canvas), canvas);
  return canvas;
}

/// The least distance from the pieces' boundaries to the zone, in px.
float nearest_px(const CollageResult& result, const Canvas& canvas) {
  float nearest = 1e9f;
  for (const Placement& p : result.placements) {
    for (const Vec2& point : library()[index_of(p.shape)].outline.curves.front()) {
      const Vec2 at = p.canvas_from_shape.apply(point);
      nearest = std::min(nearest, distance_px(kTitle, canvas.period.nearest(at, kTitle.middle_px)));
    }
  }
  return nearest;
}

TEST(KeepOut, PiecesStayOutsideAndDock) {
  const Canvas canvas = with_title(make_rectangle_canvas(240, 160));
  const CollageSettings s = improved(4);
  const CollageResult result = run(canvas, s);
  EXPECT_GT(nearest_px(result, canvas), -1.5f);
  EXPECT_LT(nearest_px(result, canvas), 1);
  const Quality q = quality(canvas, result);
  EXPECT_GT(q.coverage, 0.8) << "of what is left";
  EXPECT_LT(q.outside, 0.01);
  expect_repeatable(canvas, s, result);
}

TEST(KeepOut, PaddingIsKeptFromItToo) {
  CollageSettings s = settings();
  s.pieces.padding_px = 4;
  const Canvas canvas = with_title(make_rectangle_canvas(240, 160));
  const CollageResult result = run(canvas, s);
  ASSERT_GT(result.placements.size(), 5u);
  EXPECT_GT(nearest_px(result, canvas), 3.9f);
}

TEST(KeepOut, OnASeamlessCanvasItsImagesAreKeptOutOf) {
  for (const bool both : {false, true}) {
    const Canvas canvas = with_title(make_seamless_canvas(200, 160, true, both));
    const CollageResult result = run(canvas, settings());
    ASSERT_GT(result.placements.size(), 5u);
    EXPECT_GT(nearest_px(result, canvas), -1.5f);
    EXPECT_LT(nearest_px(result, canvas), 1) << "with it there is a boundary to begin at";
  }
}

TEST(KeepOut, EveryShapeFindsItsPlaceInWhatIsLeft) {
  CollageSettings s = settings();
  s.pieces.fit_all = true;
  s.pieces.uses = 1;
  const Canvas canvas = with_title(make_rectangle_canvas(400, 240));
  const CollageResult result =
      run(canvas, with_sizes_times(first_size_factor(s, std::uint32_t(library().size()), canvas.area_px2), s));
  EXPECT_EQ(result.placements.size(), library().size());
  EXPECT_GT(nearest_px(result, canvas), -1.5f);
}

TEST(WarmStart, ShapesThatStandNeedNoOtherPlace) {
  CollageSettings s = settings();
  s.pieces.fit_all = true;
  const auto shapes = std::uint32_t(library().size());
  const double canvas_px2 = 240 * 160;
  const double all = first_size_factor(s, shapes, canvas_px2);
  for (std::uint32_t i = 0; i + 3 < shapes; ++i) s.wishes.given.push_back({ShapeId{i}, {1, 0, 10, 10}});
  EXPECT_NEAR(first_size_factor(s, shapes, canvas_px2), all * std::sqrt(shapes / 3.), 0.01) << "for three, not for all";
}

TEST(KeepOut, RegionsKeepOutOfItToo) {
  Canvas canvas = make_rectangle_canvas(240, 160);
  canvas.regions = {{canvas.distance, canvas.area_px2}};
  canvas = with_title(std::move(canvas));
  CollageSettings s = settings();
  s.wishes.regions.resize(1);
  const CollageResult result = run(canvas, s);
  EXPECT_GT(result.placements.size(), 8u);
  EXPECT_GT(nearest_px(result, canvas), -1.5f);
}

std::vector<GivenPiece> as_given(const std::vector<Placement>& placements, bool locked) {
  std::vector<GivenPiece> given;
  for (const Placement& p : placements) given.push_back({p.shape, p.canvas_from_shape, locked});
  return given;
}

/// Some pieces of a collage, as after an edit.
std::vector<Placement> some_pieces(const Canvas& canvas) {
  std::vector<Placement> kept;
  const std::vector<Placement> all = run(canvas, settings()).placements;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i % 3 != 1) kept.push_back(all[i]);
  }
  return kept;
}

std::size_t still_there(const std::vector<GivenPiece>& given, const CollageResult& result) {
  return std::size_t(std::count_if(given.begin(), given.end(), [&](const GivenPiece& piece) {
    return std::any_of(result.placements.begin(), result.placements.end(), [&](const Placement& p) {
      return p.shape == piece.shape && p.canvas_from_shape == piece.canvas_from_shape;
    });
  }));
}

TEST(WarmStart, HolesAreFilledAgain) {
  const Canvas canvas = make_rectangle_canvas(240, 160);
  const std::vector<Placement> kept = some_pieces(canvas);
  CollageSettings s = improved(6);
  s.wishes.given = as_given(kept, true);
  const CollageResult result = run(canvas, s);
  ASSERT_GT(result.placements.size(), kept.size());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    EXPECT_EQ(result.placements[i].canvas_from_shape, kept[i].canvas_from_shape) << "in their order, first";
  }
  const Quality q = quality(canvas, result);
  EXPECT_GT(q.coverage, 0.8);
  EXPECT_LT(q.overlap, 0.01);
  expect_repeatable(canvas, s, result);
}

TEST(WarmStart, FreePiecesMayBeTakenOutByImproving) {
  const Canvas canvas = make_rectangle_canvas(240, 160);
  CollageSettings s = improved(40);
  s.wishes.given = as_given(some_pieces(canvas), false);
  const CollageResult result = run(canvas, s);
  EXPECT_LT(still_there(s.wishes.given, result), s.wishes.given.size());
  s.wishes.given = as_given(some_pieces(canvas), true);
  EXPECT_EQ(still_there(s.wishes.given, run(canvas, s)), s.wishes.given.size());
}

TEST(WarmStart, FreePiecesAreRepeatable) {
  const Canvas canvas = make_rectangle_canvas(240, 160);
  CollageSettings s = improved(8);
  s.wishes.given = as_given(some_pieces(canvas), false);
  s.wishes.given.push_back({ShapeId{4}, {7, 0, 230, 10}, false});  // smaller than the job's pieces
  s.wishes.given.insert(s.wishes.given.begin(), {ShapeId{2}, {0, 15, 30, 150}});
  expect_repeatable(canvas, s, run(canvas, s));
}

/// The job wants no more pieces. The free ones are improved, and none is added.
TEST(WarmStart, FreePiecesThatAreEnoughAreImproved) {
  const Canvas canvas = make_rectangle_canvas(240, 160);
  CollageSettings s = settings();
  s.stop.pieces = 6;
  const CollageResult few = run(canvas, s);
  ASSERT_EQ(few.placements.size(), 6u);
  s.improve.trials = 3;
  s.wishes.given = as_given(few.placements, false);
  const CollageResult result = run(canvas, s);
  EXPECT_EQ(result.placements.size(), 6u);
  EXPECT_EQ(result.statistics.trials, 3u);
  EXPECT_EQ(result.statistics.stopped_by, StopReason::pieces);
  EXPECT_GT(quality(canvas, result).coverage, quality(canvas, few).coverage + 0.01);
  s.wishes.given = as_given(few.placements, true);
  EXPECT_EQ(run(canvas, s).statistics.trials, 0u) << "nothing may move";
}

/// Files hold sizes with three decimals. A piece of the smallest allowed size may be written slightly smaller.
TEST(WarmStart, AFreePieceThatWasRoundedBeyondABoundMayGrow) {
  CollageSettings s = settings();
  s.pieces.min_scale_px = 35.43347f;
  s.pieces.max_scale_px = 80;
  s.stop.pieces = 1;
  s.improve.trials = 1;
  for (const float scale_px : {35.433f, 35.4f}) {
    s.wishes.given = {{ShapeId{2}, {scale_px, 0, 60, 60}, false}};
    const CollageResult result = run(make_rectangle_canvas(120, 120), s);
    ASSERT_EQ(result.placements.size(), 1u);
    const float now_px = result.placements[0].canvas_from_shape.scale();
    if (scale_px == 35.433f) {
      EXPECT_GT(now_px, 60) << "grown";
    } else {
      EXPECT_NEAR(now_px, scale_px, 1e-4f) << "it is meant to be smaller";
    }
  }
}

TEST(WarmStart, FreePiecesStandAgainAtEachAttemptToFitAll) {
  CollageSettings s = settings();
  s.pieces.fit_all = true;
  s.pieces.uses = 1;
  s.wishes.given = {{ShapeId{0}, {60, 0, 80, 80}, false}};
  const Canvas canvas = make_rectangle_canvas(500, 300);
  const double too_large = 1.25 * first_size_factor(s, std::uint32_t(library().size()), canvas.area_px2);
  const CollageSettings sized = with_sizes_times(too_large, s);
  const CollageResult result = run(canvas, sized);
  EXPECT_EQ(still_there(s.wishes.given, result), 1u);
  EXPECT_EQ(result.placements.size(), library().size());
  expect_repeatable(canvas, sized, result);
}

TEST(WarmStart, ACheckpointGoesOnWithTheSamePiecesOnly) {
  const Canvas canvas = make_rectangle_canvas(240, 160);
  CollageSettings s = settings();
  s.wishes.given = {{ShapeId{2}, {0, 60, 60, 60}}, {ShapeId{3}, {30, 0, 180, 60}}};
  stopped_collage::KeepLatest keeper;
  stopped_collage::StopAfter observer(2);
  stopped_collage::run(s, {3, 7}, observer, {nullptr, &keeper}, canvas, library());
  const auto go_on = [&] {
    SilentObserver silent;
    stopped_collage::run(s, {3, 7}, silent, {&keeper.latest, nullptr}, canvas, library());
  };
  EXPECT_EQ(test::message_of(go_on), "");
  s.wishes.given[1].canvas_from_shape.tx += 1;
  EXPECT_NE(test::message_of(go_on).find("the pieces of [[given]] or start.pieces have changed since it was written"),
            std::string::npos);
  s.wishes.given[1].canvas_from_shape.tx -= 1;
  EXPECT_EQ(test::message_of(go_on), "");
  s.wishes.given[1].locked = false;
  EXPECT_NE(test::message_of(go_on).find("start.pieces have changed since it was written"), std::string::npos);
  s.wishes.given.pop_back();
  EXPECT_NE(test::message_of(go_on).find("start.pieces have changed since it was written"), std::string::npos);
}

/// Free pieces count as well, even if improving took them out: growth begins at them.
TEST(WarmStart, FreePiecesAreTheSameAfterAnInterruption) {
  const Canvas canvas = make_rectangle_canvas(240, 160);
  CollageSettings s = settings();
  s.wishes.given = {{ShapeId{2}, {0, 60, 60, 60}, false}};
  stopped_collage::KeepLatest keeper;
  stopped_collage::StopAfter observer(2);
  stopped_collage::run(s, {3, 7}, observer, {nullptr, &keeper}, canvas, library());
  s.wishes.given[0].canvas_from_shape.ty += 1;
  const auto go_on = [&] {
    SilentObserver silent;
    stopped_collage::run(s, {3, 7}, silent, {&keeper.latest, nullptr}, canvas, library());
  };
  EXPECT_NE(test::message_of(go_on).find("start.pieces have changed since it was written"), std::string::npos);
}

/// The reach from the middle of the canvas to the farthest points of pieces: the mean over all directions, and the largest.
struct Spread {
  float mean_px = 0;
  float most_px = 0;
};

Spread spread(const CollageResult& result, Vec2 middle_px) {
  constexpr std::size_t kDirections = 24;
  std::array<float, kDirections> reach{};
  for (const Placement& p : result.placements) {
    for (const Vec2& point : library()[index_of(p.shape)].outline.curves.front()) {
      const Vec2 d = p.canvas_from_shape.apply(point) - middle_px;
      const auto direction = std::size_t((std::atan2(d.y, d.x) / 6.2831853f + 0.5f) * kDirections) % kDirections;
      reach[direction] = std::max(reach[direction], norm(d));
    }
  }
  Spread s;
  for (const float r : reach) {
    s.mean_px += r / kDirections;
    s.most_px = std::max(s.most_px, r);
  }
  return s;
}

CollageSettings outward(int pieces) {
  CollageSettings s = settings();
  s.start.grow_outward = true;
  s.stop.pieces = pieces;
  return s;
}

/// The objects with which the loop begins a collage.
struct Beginning {
  Beginning(const Canvas& canvas, const CollageSettings& s, const std::vector<Placement>& standing)
      : context(make_matching_context(s, std::uint32_t(library().size()))),
        collage(canvas, s, context, shapes) {
    collage.grow_by(OutwardGrowth(canvas, s.pieces, standing, shapes));
    collage.begin(standing, standing.size(), 0);
  }

  test::VectorShapes shapes{library()};
  MatchingContext context;
  Collage collage;
};

TEST(OutwardGrowth, TargetSamplesLieOnWhatStandsNeverOnTheEdge) {
  for (const float padding_px : {0.f, 5.f}) {
    CollageSettings s = outward(0);
    s.pieces.padding_px = padding_px;
    const Canvas canvas = with_title(make_rectangle_canvas(300, 240));
    Beginning beginning(canvas, s, {{ShapeId{5}, {60, 0, 220, 180}, 0, 0}});
    int on_zone = 0;
    int on_piece = 0;
    for (int pass = 0; pass < 2; ++pass) {
      for (const TargetSample& sample : beginning.collage.schedule().take()) {
        const Vec2 p = sample.position;
        EXPECT_GT(std::min({p.x, p.y, 300 - p.x, 240 - p.y}), padding_px + 2);
        distance_px(kTitle, p) < padding_px + 2 ? ++on_zone : ++on_piece;
      }
      beginning.collage.schedule().mark({0, 0, 400, 400});
    }
    EXPECT_GT(on_zone, 20);
    EXPECT_GT(on_piece, 20);
  }
}

TEST(OutwardGrowth, ZonesAtTheEdgeAreDockedTo) {
  Canvas canvas = make_rectangle_canvas(300, 240);
  take_out(distance_to({KeepOutRectangle{{0, 120}, {40, 60}}}, canvas), canvas);
  test::VectorShapes shapes(library());
  const OutwardGrowth growth(canvas, settings().pieces, {}, shapes);
  const FreeField free(canvas, settings().pieces);
  EXPECT_TRUE(growth.may_dock(free, {40, 120}));
  EXPECT_TRUE(growth.may_dock(free, {20, 60.5f}));
  EXPECT_FALSE(growth.may_dock(free, {0.5f, 20}));
  EXPECT_FALSE(growth.may_dock(free, {299.5f, 120}));
  EXPECT_TRUE(growth.may_dock(free, {150, 120}));
}

TEST(OutwardGrowth, TheFirstPieceLiesDeepestInTheCanvas) {
  Grid<float> coverage(800, 400, 0.f);
  for (int y = 0; y < 400; ++y) {
    for (int x = 0; x < 800; ++x) coverage(x, y) = float(x < 300 || (y > 180 && y < 220));  // a square with a long tail
  }
  test::VectorShapes shapes(library());
  const OutwardGrowth growth(make_mask_canvas(coverage), settings().pieces, {}, shapes);
  EXPECT_NEAR(growth.first_piece_px().x, 75, 2);
  EXPECT_NEAR(growth.first_piece_px().y, 100, 26) << "anywhere on the square's middle line";
  EXPECT_GT(growth.nearness(growth.first_piece_px()), 0.9f);
  EXPECT_LT(growth.nearness({200, 100}), 0.5f);
}

TEST(OutwardGrowth, IsRoundWithoutASeed) {
  const Canvas canvas = make_rectangle_canvas(600, 500);
  CollageSettings s = outward(20);
  s.pieces.max_scale_px = 60;
  const CollageResult result = run(canvas, s);
  ASSERT_EQ(result.placements.size(), 20u);
  const Spread reach = spread(result, {300, 250});
  EXPECT_LT(reach.most_px, 170) << "far from the canvas' edge";
  EXPECT_LT(reach.most_px, 1.3f * reach.mean_px);
  EXPECT_LT(quality(canvas, result).overlap, 0.006);
}

TEST(OutwardGrowth, BeginsAtWhatIsGiven) {
  CollageSettings s = outward(14);
  s.wishes.given = {{ShapeId{5}, {70, 0, 150, 330}}};
  const CollageResult result = run(make_rectangle_canvas(600, 500), s);
  ASSERT_EQ(result.placements.size(), 14u);
  for (const Placement& p : result.placements) EXPECT_LT(norm(p.canvas_from_shape.translation() - Vec2{150, 330}), 160);
}

TEST(OutwardGrowth, BeginsAtZones) {
  const Canvas canvas = with_title(make_rectangle_canvas(600, 500));
  const CollageResult result = run(canvas, outward(10));
  ASSERT_EQ(result.placements.size(), 10u);
  for (const Placement& p : result.placements) EXPECT_LT(distance_px(kTitle, p.canvas_from_shape.translation()), 125);
  EXPECT_LT(nearest_px(result, canvas), 1);
}

TEST(OutwardGrowth, FillsTheCanvasToItsEdge) {
  CollageSettings s = outward(0);
  const Canvas canvas = make_rectangle_canvas(240, 160);
  const CollageResult result = run(canvas, s);
  EXPECT_EQ(result.statistics.stopped_by, StopReason::full);
  const Quality q = quality(canvas, result);
  EXPECT_GT(q.coverage, 0.78);
  EXPECT_LT(q.outside, 0.01);
  s.improve.trials = 5;
  s.wishes.given = as_given(some_pieces(canvas), false);
  expect_repeatable(canvas, s, run(canvas, s));
}

TEST(OutwardGrowth, ASecondRegionHasASeedOfItsOwnWhereNothingReachesIt) {
  Canvas canvas = make_rectangle_canvas(500, 200);
  for (const int left : {0, 320}) {
    Grid<float> coverage(1000, 400, 0.f);
    for (int y = 20; y < 380; ++y) {
      for (int x = 2 * left + 20; x < 2 * left + 340; ++x) coverage(x, y) = 1;
    }
    const Canvas part = make_mask_canvas(coverage);
    canvas.regions.push_back({part.distance, part.area_px2});
  }
  CollageSettings s = outward(0);
  s.wishes.regions.resize(2);
  int right = 0;
  for (const Placement& p : run(canvas, s).placements) right += p.canvas_from_shape.tx > 300;
  EXPECT_GT(right, 4);
}

}  // namespace test_start
}  // namespace tessera::master
