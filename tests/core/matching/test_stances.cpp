// The stances of shapes: from the job's wishes, and within the limits of the moment.
#include "core/matching/stances.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

namespace tessera {
namespace test_stances {

constexpr float kTurn_rad = 6.2831853f;

CollageSettings settings() {
  CollageSettings s;
  s.pieces.min_scale_px = 20;
  s.pieces.max_scale_px = 120;
  return s;
}

ShapeWish wish_of(const PoseWish& poses) {
  ShapeWish wish;
  wish.poses = poses;
  return wish;
}

bool inside(const std::vector<Interval>& intervals, float value) {
  return std::any_of(intervals.begin(), intervals.end(),
                     [&](const Interval& i) { return i.min <= value && value <= i.max; });
}

TEST(Stances, WithoutWishesEveryShapeHasTheJobsOwn) {
  const StanceTable table(settings(), 7);
  EXPECT_TRUE(table.all_open());
  EXPECT_EQ(table.open_shapes(), 7u);
  EXPECT_EQ(table.open_shape(5), ShapeId{5});
  ASSERT_EQ(table.list(ShapeId{3}).count, 1u);
  const Stance& only = table.of(table.list(ShapeId{3}))[0];
  EXPECT_EQ(only.poses.min_scale_px, 20);
  EXPECT_EQ(only.poses.max_scale_px, 120);
  EXPECT_TRUE(only.poses.rotations.all());
  EXPECT_EQ(only.weight, 1);
}

TEST(Stances, AreAllPairsOfScalesAndRotationsSmallOnesFirst) {
  CollageSettings s = settings();
  s.pieces.several.scale_px = {{80, 120}, {20, 30}};
  s.pieces.several.rotation_rad = {{0, 0}, {1, 1}, {2, 2}};
  const StanceTable table(s, 1);
  const auto stances = table.of(table.list(ShapeId{0}));
  ASSERT_EQ(stances.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(stances[i].poses.min_scale_px, i < 3 ? 20 : 80);
  EXPECT_FLOAT_EQ(stances[4].poses.rotations.middle.x, std::cos(1.f));
  EXPECT_EQ(table.list(ShapeId{0}).min_scale_px, 20);
  EXPECT_EQ(table.list(ShapeId{0}).max_scale_px, 120);
}

TEST(Stances, AShapesOwnWishComesFirstAndARegionLimitsIt) {
  CollageSettings s = settings();
  s.wishes.classes = {{}, wish_of({{{30, 90}}, {}}), wish_of({{{100, 110}}, {}})};
  s.wishes.class_of_shape = {0, 1, 2};
  s.wishes.regions.resize(2);
  s.wishes.regions[1].poses.scale_px = {{50, 70}};
  const StanceTable first(s, 3);
  EXPECT_EQ(first.list(ShapeId{0}).max_scale_px, 120);
  EXPECT_EQ(first.list(ShapeId{1}).min_scale_px, 30);
  const StanceTable second = first.limited({.region = 1});
  EXPECT_EQ(second.list(ShapeId{0}).max_scale_px, 70) << "the region's instead of the job's";
  EXPECT_EQ(second.list(ShapeId{1}).min_scale_px, 50);
  EXPECT_EQ(second.list(ShapeId{2}).count, 0u) << "nothing in common";
  EXPECT_EQ(second.open_shapes(), 2u);
}

TEST(Stances, AShapeStandsInItsRegionsAloneAndWithoutWeightNowhere) {
  CollageSettings s = settings();
  s.wishes.classes.resize(3);
  s.wishes.classes[1].in_region = {0, 1};
  s.wishes.classes[2].weight = 0;
  s.wishes.class_of_shape = {0, 1, 2, 1};
  s.wishes.regions.resize(2);
  const StanceTable table(s, 4);
  EXPECT_EQ(table.open_shapes(), 1u);
  EXPECT_EQ(table.open_shape(0), ShapeId{0});
  const StanceTable second = table.limited({.region = 1});
  EXPECT_EQ(second.open_shapes(), 3u);
  EXPECT_EQ(second.open_shape(2), ShapeId{3});
}

TEST(Stances, LimitsLeaveWhatIsSmallEnoughAndNotUsedUp) {
  CollageSettings s = settings();
  s.pieces.several.scale_px = {{20, 30}, {40, 90}, {100, 120}};
  const StanceTable all(s, 4);
  const StanceTable table = all.limited({.most_scale_px = 60, .used_up = {ShapeId{1}, ShapeId{3}}});
  EXPECT_EQ(table.open_shapes(), 2u);
  EXPECT_EQ(table.open_shape(1), ShapeId{2});
  EXPECT_EQ(table.list(ShapeId{1}).count, 0u);
  ASSERT_EQ(table.list(ShapeId{2}).count, 2u);
  EXPECT_EQ(table.list(ShapeId{2}).max_scale_px, 60);
  EXPECT_EQ(table[1].poses.max_scale_px, 60);
  EXPECT_FLOAT_EQ(table[1].log2_scale_ratio, std::log2(60.f / 40));
  EXPECT_EQ(table[2].poses.min_scale_px, 100) << "a stance keeps its place";
  EXPECT_EQ(all.limited({.most_scale_px = 19}).open_shapes(), 0u);
}

/// Both ranges allow a rotation exactly if each of them does, whatever turn it was written with.
TEST(Stances, CommonRotationsAreThoseOfBoth) {
  EXPECT_TRUE(rc::check([] {
    const auto interval = [] {
      const float low = 0.01f * float(*rc::gen::inRange(-628, 400));
      return Interval{low, low + 0.01f * float(*rc::gen::inRange(0, 200))};
    };
    const std::vector<Interval> a{interval(), interval()};
    const std::vector<Interval> b{interval()};
    const std::vector<Interval> common = common_rotations(a, b);
    const float angle = 0.01f * float(*rc::gen::inRange(-314, 314)) + 0.005f;
    const auto allowed = [&](const std::vector<Interval>& intervals) {
      for (int turns = -3; turns <= 3; ++turns) {
        if (inside(intervals, angle + float(turns) * kTurn_rad)) return true;
      }
      return false;
    };
    RC_ASSERT(allowed(common) == (allowed(a) && allowed(b)));
  }));
}

TEST(Stances, ARangeOfAWholeTurnLimitsNothing) {
  const std::vector<Interval> any{{-3.15f, 3.15f}};
  const std::vector<Interval> some{{1, 2}, {7, 8}};
  EXPECT_EQ(common_rotations(any, some), some);
  EXPECT_EQ(common_rotations(some, any), some);
}

TEST(Stances, SizesByPlaceArePartOfTheirOctaves) {
  CollageSettings settings;
  settings.pieces.min_scale_px = 10;
  settings.pieces.max_scale_px = 160;
  const Stance whole = StanceTable(settings, 1)[0];
  const Stance half = with_sizes_up_to(0.5f, whole);
  EXPECT_FLOAT_EQ(half.poses.min_scale_px, 10);
  EXPECT_FLOAT_EQ(half.poses.max_scale_px, 40);
  EXPECT_FLOAT_EQ(half.log2_scale_ratio, 2);
  EXPECT_EQ(with_sizes_up_to(1, whole).poses.max_scale_px, whole.poses.max_scale_px);
  EXPECT_FLOAT_EQ(with_sizes_up_to(0, whole).poses.max_scale_px, 10);
}

TEST(Stances, SizeMapIsLinearBetweenItsCellsAndGoesOnBeyond) {
  SizeMap map{Grid<float>(2, 2), 0.1f};  // cells of 10 px
  map.part(1, 0) = 1;
  EXPECT_FLOAT_EQ(map.at({5, 5}), 0);
  EXPECT_FLOAT_EQ(map.at({15, 5}), 1);
  EXPECT_FLOAT_EQ(map.at({10, 5}), 0.5f);
  EXPECT_FLOAT_EQ(map.at({10, 10}), 0.25f);
  EXPECT_FLOAT_EQ(map.at({-90, -90}), 0);
  EXPECT_FLOAT_EQ(map.at({90, -90}), 1);
}

}  // namespace test_stances
}  // namespace tessera
