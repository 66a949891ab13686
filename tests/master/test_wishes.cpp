// Wishes in whole collages: who stands where, what is given, every shape once; and each of them after interruptions.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/matching/sized_settings.h"
#include "interrupted_collage.h"
#include "whole_collage.h"

namespace tessera::master {
namespace {

using namespace whole_collage;

std::map<std::uint32_t, int> uses(const std::vector<Placement>& placements) {
  std::map<std::uint32_t, int> count;
  for (const Placement& p : placements) ++count[index_of(p.shape)];
  return count;
}

/// Two regions side by side on a page of 240 x 140.
Canvas two_regions() {
  Canvas canvas = make_rectangle_canvas(240, 140);
  for (const bool right : {false, true}) {
    Grid<float> coverage(480, 280, 0.f);
    for (int y = 0; y < 280; ++y) {
      for (int x = 0; x < 480; ++x) coverage(x, y) = float((x >= 240) == right);
    }
    canvas.regions.push_back(make_mask_canvas(coverage).distance);
  }
  return canvas;
}

TEST(Wishes, SizesAndAnglesAreThoseThatWereWishedFor) {
  CollageSettings s = settings();
  s.pieces.several.scale_px = {{20, 24}, {60, 90}};
  s.pieces.several.rotation_rad = {{0, 0}, {1.5707964f, 1.5707964f}};
  const Canvas canvas = make_rectangle_canvas(240, 180);
  const CollageResult result = run(canvas, s);
  ASSERT_GT(result.placements.size(), 8u);
  std::set<bool> turned;
  for (const Placement& p : result.placements) {
    const float scale = p.canvas_from_shape.scale();
    EXPECT_TRUE((scale > 19.99f && scale < 24.01f) || (scale > 59.99f && scale < 90.01f)) << scale;
    const float angle = p.canvas_from_shape.rotation_rad();
    EXPECT_TRUE(std::abs(angle) < 1e-4f || std::abs(angle - 1.5707964f) < 1e-4f) << angle;
    turned.insert(angle > 1);
  }
  EXPECT_EQ(turned.size(), 2u);
  expect_repeatable(canvas, s, result);
}

TEST(Wishes, OneSizeFillsToo) {
  CollageSettings s = settings();
  s.pieces.min_scale_px = s.pieces.max_scale_px = 40;
  const Canvas canvas = make_rectangle_canvas(240, 180);
  const CollageResult result = run(canvas, s);
  EXPECT_GT(quality(canvas, result).coverage, 0.6);
  for (const Placement& p : result.placements) EXPECT_NEAR(p.canvas_from_shape.scale(), 40, 0.001f);
}

TEST(Wishes, WeightsChangeHowOftenAShapeStands) {
  CollageSettings s = settings();
  const Canvas canvas = make_rectangle_canvas(300, 220);
  const int plain = uses(run(canvas, s).placements)[3];
  s.wishes.classes.resize(2);
  s.wishes.classes[1].weight = 3;
  s.wishes.class_of_shape.assign(library().size(), 0);
  s.wishes.class_of_shape[3] = 1;
  EXPECT_GT(uses(run(canvas, s).placements)[3], plain);
  s.wishes.classes[1].weight = 0;
  EXPECT_EQ(uses(run(canvas, s).placements)[3], 0);
}

TEST(Wishes, GivenPiecesStandAndTheOthersKeepClear) {
  CollageSettings s = improved(6);
  const Similarity hero{0, 110, 130, 80};
  s.wishes.given = {{ShapeId{2}, hero}};
  const Canvas canvas = make_rectangle_canvas(260, 180);
  const CollageResult result = run(canvas, s);
  ASSERT_GT(result.placements.size(), 5u);
  EXPECT_EQ(result.placements[0].shape, ShapeId{2});
  EXPECT_EQ(result.placements[0].canvas_from_shape, hero);
  const Quality q = quality(canvas, result);
  EXPECT_GT(q.coverage, 0.75);
  EXPECT_LT(q.overlap, 0.006);
  expect_repeatable(canvas, s, result);
}

TEST(Wishes, RegionsHaveTheirOwnShapesAndSizes) {
  CollageSettings s = improved(4);
  s.wishes.regions.resize(2);
  s.wishes.regions[1].poses.scale_px = {{20, 30}};
  s.wishes.classes.resize(2);
  s.wishes.classes[0].in_region = {1, 1};
  s.wishes.classes[1].in_region = {0, 1};
  s.wishes.class_of_shape.assign(library().size(), 0);
  for (std::size_t i = 0; i < library().size(); i += 2) s.wishes.class_of_shape[i] = 1;
  const Canvas canvas = two_regions();
  const CollageResult result = run(canvas, s);
  int left = 0;
  int right = 0;
  for (const Placement& p : result.placements) {
    if (p.canvas_from_shape.tx < 120) {
      ++left;
      EXPECT_EQ(index_of(p.shape) % 2, 1u);
    } else {
      ++right;
      EXPECT_LE(p.canvas_from_shape.scale(), 30.01f);
    }
    float leftmost = 1e9f;
    float rightmost = -1e9f;
    for (const Vec2& point : library()[index_of(p.shape)].outline.curves.front()) {
      const float x = p.canvas_from_shape.apply(point).x;
      leftmost = std::min(leftmost, x);
      rightmost = std::max(rightmost, x);
    }
    EXPECT_TRUE(rightmost < 122 || leftmost > 118) << "within its region";
  }
  EXPECT_GT(left, 2);
  EXPECT_GT(right, 10);
  EXPECT_LT(quality(canvas, result).overlap, 0.006);
  expect_repeatable(canvas, s, result);
}

TEST(Wishes, WithLeastUsesNoShapeComesAgainBeforeAllAreThere) {
  CollageSettings s = settings();
  s.pieces.least_uses = 1;
  s.pieces.max_scale_px = 40;
  const Canvas canvas = make_rectangle_canvas(300, 220);
  const CollageResult result = run(canvas, s);
  ASSERT_GT(result.placements.size(), library().size());
  std::set<std::uint32_t> first;
  for (std::size_t i = 0; i < library().size(); ++i) first.insert(index_of(result.placements[i].shape));
  EXPECT_EQ(first.size(), library().size());
}

TEST(Wishes, FitAllFindsSizesAtWhichEveryShapeHasItsPlace) {
  CollageSettings s = improved(4);
  s.pieces.fit_all = true;
  s.pieces.uses = 1;
  const Canvas canvas = make_rectangle_canvas(500, 300);
  const double factor = first_size_factor(s, std::uint32_t(library().size()), canvas.area_px2);
  const CollageSettings sized = with_sizes_times(factor, s);
  const CollageResult result = run(canvas, sized);
  EXPECT_EQ(uses(result.placements).size(), library().size());
  EXPECT_EQ(result.placements.size(), library().size());
  EXPECT_EQ(result.statistics.stopped_by, "used_up");
  EXPECT_GT(quality(canvas, result).coverage, 0.65);
  expect_repeatable(canvas, sized, result);
}

TEST(Wishes, FitAllKeepsTheSizesOfShapesInProportion) {
  CollageSettings s = settings();
  s.pieces.fit_all = true;
  s.pieces.uses = 1;
  s.wishes.classes.resize(2);
  s.wishes.classes[0].poses.scale_px = {{100, 100}};
  s.wishes.classes[1].poses.scale_px = {{50, 50}};
  s.wishes.class_of_shape.assign(library().size(), 1);
  s.wishes.class_of_shape[0] = s.wishes.class_of_shape[5] = 0;
  const Canvas canvas = make_rectangle_canvas(500, 300);
  const double factor = first_size_factor(s, std::uint32_t(library().size()), canvas.area_px2);
  const CollageResult result = run(canvas, with_sizes_times(factor, s));
  ASSERT_EQ(result.placements.size(), library().size());
  std::map<bool, std::set<int>> sizes;
  for (const Placement& p : result.placements) {
    const bool large = index_of(p.shape) == 0 || index_of(p.shape) == 5;
    sizes[large].insert(int(std::lround(1000 * p.canvas_from_shape.scale())));
  }
  EXPECT_EQ(sizes[false].size(), 1u);
  EXPECT_EQ(sizes[true].size(), 1u);
  EXPECT_NEAR(*sizes[true].begin(), 2 * *sizes[false].begin(), 3);
}

TEST(Wishes, ALibraryThatIsUsedUpIsSaidAsSuch) {
  CollageSettings s = settings();
  s.pieces.uses = 1;
  s.pieces.max_scale_px = 30;
  EXPECT_EQ(run(make_rectangle_canvas(300, 220), s).statistics.stopped_by, "used_up");
}

}  // namespace
}  // namespace tessera::master
