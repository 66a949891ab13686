// The worth of a colour beside the placed pieces.
#include "master/rules/neighbour_colours.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "core/settings/tuning.h"

namespace tessera::master {
namespace test_neighbour_colours {

constexpr ShapeId kRed{0}, kDarkRed{1}, kBlue{2};
const float kWorst = 1.f / 16;  // 2^-kNeighbourFading

ColourWish wish(float neighbours) {
  ColourWish w;
  w.of_shapes = std::make_shared<const std::vector<ShapeColour>>(
      std::vector<ShapeColour>{{{53, 80, 67}}, {{40, 70, 57}}, {{32, 79, -108}}});
  w.neighbours = neighbours;
  return w;
}

Placement placed(ShapeId shape, Vec2 centre, float scale_px = 40) {
  return {shape, {scale_px, 0, centre.x, centre.y}, 1, 1};
}

Similarity pose(Vec2 centre, float scale_px = 40) { return {scale_px, 0, centre.x, centre.y}; }

TEST(NeighbourColours, OfNoWeightDoNotMatter) {
  NeighbourColours colours({}, {});
  colours.add(placed(kRed, {100, 100}));
  EXPECT_EQ(colours.worth(kRed, pose({110, 100})), 1);
}

TEST(NeighbourColours, LikeOnesAreWelcomeAboveZero) {
  NeighbourColours colours(wish(1), {});
  colours.add(placed(kRed, {100, 100}));
  EXPECT_FLOAT_EQ(colours.worth(kRed, pose({140, 100})), 1);
  EXPECT_FLOAT_EQ(colours.worth(kBlue, pose({140, 100})), kWorst);
  const float dark = colours.worth(kDarkRed, pose({140, 100}));
  EXPECT_GT(dark, 0.4f);
  EXPECT_LT(dark, 0.9f);
}

TEST(NeighbourColours, UnlikeOnesAreWelcomeBelowZero) {
  NeighbourColours colours(wish(-1), {});
  colours.add(placed(kRed, {100, 100}));
  EXPECT_FLOAT_EQ(colours.worth(kRed, pose({140, 100})), kWorst);
  EXPECT_FLOAT_EQ(colours.worth(kBlue, pose({140, 100})), 1);
  EXPECT_LT(colours.worth(kDarkRed, pose({140, 100})), 0.2f);
}

TEST(NeighbourColours, TheWeightCounts) {
  NeighbourColours colours(wish(-0.5f), {});
  colours.add(placed(kRed, {100, 100}));
  EXPECT_FLOAT_EQ(colours.worth(kRed, pose({140, 100})), 0.25f);
}

TEST(NeighbourColours, TheLessLikeOneIsWorthMoreWhateverTheWeight) {
  for (const float weight : {-1.f, -10.f, -100.f}) {
    NeighbourColours colours(wish(weight), {});
    colours.add(placed(kRed, {100, 100}));
    const float red = colours.worth(kRed, pose({140, 100})), dark = colours.worth(kDarkRed, pose({140, 100}));
    EXPECT_GT(dark, 1.0001f * red) << weight;
    EXPECT_GT(colours.worth(kBlue, pose({140, 100})), 1.0001f * dark) << weight;
  }
}

/// Two pieces of 40 px are neighbours within kNeighbourReach * 80 px.
TEST(NeighbourColours, NeighboursAreNear) {
  NeighbourColours colours(wish(-1), {});
  colours.add(placed(kRed, {100, 100}));
  const float reach_px = kNeighbourReach * 80;
  EXPECT_FLOAT_EQ(colours.worth(kRed, pose({100 + reach_px + 1, 100})), 1);
  EXPECT_FLOAT_EQ(colours.worth(kRed, pose({100 + reach_px - 1, 100})), kWorst);
  EXPECT_FLOAT_EQ(colours.worth(kRed, pose({100, 100 - reach_px + 1})), kWorst);
}

TEST(NeighbourColours, NeighboursAreNearAcrossASeam) {
  NeighbourColours colours(wish(-1), {300, 0});
  colours.add(placed(kRed, {10, 100}));
  EXPECT_FLOAT_EQ(colours.worth(kRed, pose({290, 100})), kWorst);
  EXPECT_FLOAT_EQ(colours.worth(kRed, pose({150, 100})), 1);
  EXPECT_FLOAT_EQ(colours.worth(kRed, pose({10, 390})), 1) << "no seam that way";
}

TEST(NeighbourColours, AreForgotten) {
  NeighbourColours colours(wish(-1), {});
  colours.add(placed(kRed, {100, 100}));
  colours.forget_placements();
  EXPECT_FLOAT_EQ(colours.worth(kRed, pose({100, 100})), 1);
}

/// The index finds the same neighbours as a look at every piece, in any order, and further pieces never raise the worth.
RC_GTEST_PROP(NeighbourColours, TheLeastWelcomeOfAllNeighboursCounts, ()) {
  const Period period{*rc::gen::element(0, 300), *rc::gen::element(0, 400)};
  const auto placement = [] {
    const ShapeId shape{*rc::gen::inRange(0u, 3u)};
    const Vec2 centre{float(*rc::gen::inRange(0, 300)), float(*rc::gen::inRange(0, 400))};
    return placed(shape, centre, float(*rc::gen::inRange(4, 90)));
  };
  const ColourWish wished = wish(*rc::gen::element(-1.f, 0.7f));
  std::vector<Placement> all;
  for (int i = *rc::gen::inRange(0, 12); i > 0; --i) all.push_back(placement());
  const Placement candidate = placement();
  const auto worth = [&](const std::vector<Placement>& placements) {
    NeighbourColours colours(wished, period);
    for (const Placement& p : placements) colours.add(p);
    return colours.worth(candidate.shape, candidate.canvas_from_shape);
  };
  float least = 1, before = 1;
  std::vector<Placement> so_far;
  for (const Placement& p : all) {
    least = std::min(least, worth({p}));
    so_far.push_back(p);
    const float now = worth(so_far);
    RC_ASSERT(now == least);
    RC_ASSERT(now <= before);
    before = now;
  }
  std::reverse(all.begin(), all.end());
  RC_ASSERT(worth(all) == least);
}

}  // namespace test_neighbour_colours
}  // namespace tessera::master
