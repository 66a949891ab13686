#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/colour/ciede2000.h"
#include "core/matching/colour_fit.h"
#include "core/matching/near_colours.h"
#include "core/settings/tuning.h"
#include "support/colours.h"

namespace tessera {
namespace test_colour_target {

using test::opaque;

const Lab kDark{20, 0, 0};
const Lab kLight{90, 0, 0};

/// A picture that is dark to the left of the middle.
std::shared_ptr<const ColourTarget> halves() {
  return test::picture(256, 256, [](Vec2 p) { return opaque(p.x < 128 ? kDark : kLight); });
}

TEST(ColourTarget, LevelsAreMeansOfEachOther) {
  const auto target = test::picture(64, 64, [](Vec2 p) { return opaque({p.x, p.y, 0}); });
  const int last = int(target->levels().size()) - 1;
  EXPECT_EQ(last, 5) << "32 texels each way, halved five times";
  EXPECT_FLOAT_EQ(target->at(last, {0, 0}).lightness, 32);
  EXPECT_FLOAT_EQ(target->at(1, {30, 50}).lightness, 30) << "linear between the texels";
  EXPECT_FLOAT_EQ(target->at(1, {30, 50}).a, 50);
  EXPECT_EQ(target->at(0, {-50, 900}), target->at(0, {0, 64})) << "its edge goes on";
}

TEST(ColourTarget, LevelGoesByLength) {
  const auto target = halves();  // 2 px per texel
  EXPECT_EQ(target->level_for(0.1f), 0);
  EXPECT_EQ(target->level_for(3.9f), 0);
  EXPECT_EQ(target->level_for(4), 1);
  EXPECT_EQ(target->level_for(31), 3);
  EXPECT_EQ(target->level_for(1e9f), int(target->levels().size()) - 1);
}

TEST(ColourTarget, OddSizesLoseNothing) {
  Grid<Texel> finest(5, 3, opaque({50, 10, -10}));
  const ColourTarget target(finest, 1.5f);
  for (int level = 0; level < int(target.levels().size()); ++level) {
    EXPECT_EQ(target.at(level, {7.4f, 4.4f}), opaque({50, 10, -10})) << level;
  }
  EXPECT_EQ(target.levels()[1].width, 3u);
  EXPECT_EQ(target.levels()[1].height, 2u);
}

/// A half-dark tile fits along the edge in only one of two directions.
TEST(ColourFit, PartsOfAPieceAreComparedWhereTheyLie) {
  const ColourModel tile = make_colour_model(test::two_toned_grid(kDark, kLight), {-0.5f, -0.5f}, {0.5f, 0.5f});
  const Similarity along{40, 0, 128, 100};
  const Similarity against{-40, 0, 128, 100};
  EXPECT_LT(colour_difference(tile, along, *halves()), 4);
  EXPECT_GT(colour_difference(tile, against, *halves()), 25);
  EXPECT_NEAR(mean_colour_difference(tile, along, *halves()), mean_colour_difference(tile, against, *halves()), 0.01f);
  const Similarity aside{40, 0, 60, 100};
  EXPECT_GT(mean_colour_difference(tile, aside, *halves()), 15);
}

/// The cells of both tiles have the same mean difference.
TEST(ColourFit, APartOfQuiteAnotherColourCostsMoreThanAllALittleOff) {
  const auto smooth = test::picture(256, 256, [](Vec2) { return opaque({50, 0, 0}); });
  const Similarity pose{40, 0, 128, 128};
  const auto tile = [](const Lab& upper, const Lab& lower) {
    return make_colour_model(test::two_toned_grid(upper, lower), {-0.5f, -0.5f}, {0.5f, 0.5f});
  };
  const float even = colour_difference(tile({60, 0, 0}, {60, 0, 0}), pose, *smooth);
  const float restless = colour_difference(tile({70, 0, 0}, {50, 0, 0}), pose, *smooth);
  EXPECT_NEAR(even, ciede2000({60, 0, 0}, {50, 0, 0}), 0.2f);
  EXPECT_GT(restless, 1.2f * even);
}

TEST(ColourFit, WhatIsTransparentWishesNothing) {
  const auto target = test::picture(256, 256, [](Vec2 p) { return p.x < 128 ? opaque(kDark) : Texel{}; });
  const ColourModel tile = make_colour_model(test::two_toned_grid(kDark, kLight), {-0.5f, -0.5f}, {0.5f, 0.5f});
  EXPECT_EQ(colour_difference(tile, {40, 0, 200, 100}, *target), 0);
  EXPECT_EQ(mean_colour_difference(tile, {40, 0, 200, 100}, *target), 0);
  const ColourModel dark = make_colour_model(test::two_toned_grid(kDark, kDark), {-0.5f, -0.5f}, {0.5f, 0.5f});
  EXPECT_LT(colour_difference(dark, {40, 0, 128, 100}, *target), 1) << "its dark half counts alone";
}

TEST(ColourFit, WorthFallsWithDifferenceAndWeight) {
  EXPECT_EQ(colour_worth(0, 1), 1);
  EXPECT_NEAR(colour_worth(1 / kColourFading, 1), 0.5f, 1e-6f);
  EXPECT_NEAR(colour_worth(1 / kColourFading, 2), 0.25f, 1e-6f);
  EXPECT_EQ(colour_worth(50, 0), 1);
  EXPECT_GT(colour_worth(200, 100), 0) << "never nothing: a wrong colour is better than a hole";
  for (const float weight : {0.5f, 4.f, 20.f, 100.f}) {
    for (float difference = 0; difference < 100; difference += 4) {
      EXPECT_GT(colour_worth(difference, weight), 1.0001f * colour_worth(difference + 4, weight))
          << "the nearer colour is worth more, whatever the weight: " << weight << ", " << difference;
    }
  }
}

/// A sample at p whose region lies to its right in the picture.
TargetSample sample_at(Vec2 p) {
  TargetSample sample;
  sample.position = p;
  sample.tangent = {0, -1};
  return sample;
}

std::vector<Lab> greys(int count) {
  std::vector<Lab> colours;
  for (int i = 0; i < count; ++i) colours.push_back({100.f * float(i) / float(count - 1), 0, 0});
  return colours;
}

TEST(NearColours, ListTheNearestOnTheInside) {
  NearColours near(test::wish_for(halves(), greys(1001)), 20);
  near.start(StanceTable(CollageSettings(), 1001));
  EXPECT_EQ(near.length(), 1001u / 4);
  const NearColours::List dark = near.list_for(sample_at({60, 100}));
  const NearColours::List light = near.list_for(sample_at({124, 100}));
  EXPECT_NE(dark, light) << "what lies 20 px inside counts, not the edge";
  EXPECT_EQ(near.list_for(sample_at({70, 200})), dark) << "places of one colour share it";
  for (const std::uint32_t shape : near.shapes(dark)) EXPECT_LT(shape, 500u);
  for (const std::uint32_t shape : near.shapes(light)) EXPECT_GT(shape, 600u);
  std::uint32_t held = 0;
  for (std::uint32_t shape = 0; shape < 1001; ++shape) held += near.holds(dark, ShapeId(shape));
  EXPECT_EQ(held, near.length());
  const auto& shapes = near.shapes(light);
  const Lab wanted{88, 0, 0};  // a colour of the lattice
  for (std::size_t i = 1; i < shapes.size(); ++i) {
    EXPECT_LE(ciede2000(wanted, greys(1001)[shapes[i - 1]]), ciede2000(wanted, greys(1001)[shapes[i]]));
  }
}

/// Every other grey has a contrast of its own.
TEST(NearColours, RestlessDrawingsComeLater) {
  ColourWish wish = test::wish_for(halves(), greys(1001));
  std::vector<ShapeColour> colours = *wish.of_shapes;
  for (std::size_t i = 0; i < colours.size(); i += 2) colours[i].own_contrast = 20;
  wish.of_shapes = std::make_shared<const std::vector<ShapeColour>>(colours);
  NearColours near(wish, 20);
  near.start(StanceTable(CollageSettings(), 1001));
  for (const std::uint32_t shape : near.shapes(near.list_for(sample_at({60, 100})))) EXPECT_EQ(shape % 2, 1u) << shape;
}

TEST(NearColours, AreOfShapesThatMayStand) {
  NearColours near(test::wish_for(halves(), greys(200)), 20);
  const StanceTable all(CollageSettings(), 200);
  near.start(all);
  EXPECT_EQ(near.length(), kLeastNearColours);
  const NearColours::List before = near.list_for(sample_at({60, 100}));
  StanceLimits limits;
  for (std::uint32_t shape = 20; shape < 60; ++shape) limits.used_up.push_back(ShapeId(shape));
  near.start(all.limited(limits));
  const NearColours::List list = near.list_for(sample_at({60, 100}));
  EXPECT_EQ(list, before) << "the first again";
  for (const std::uint32_t shape : near.shapes(list)) EXPECT_TRUE(shape < 20 || shape >= 60) << shape;
  limits.used_up.clear();
  for (std::uint32_t shape = 0; shape < 197; ++shape) limits.used_up.push_back(ShapeId(shape));
  near.start(all.limited(limits));
  EXPECT_EQ(near.length(), 3u);
}

TEST(NearColours, WithoutAWishAnyShapeWillDo) {
  const StanceTable all(CollageSettings(), 200);
  NearColours none(ColourWish{}, 20);
  none.start(all);
  EXPECT_EQ(none.list_for(sample_at({60, 100})), NearColours::kAny);
  EXPECT_TRUE(none.holds(NearColours::kAny, ShapeId{7}));
  NearColours no_weight(test::wish_for(halves(), greys(200), 0), 20);
  no_weight.start(all);
  EXPECT_EQ(no_weight.list_for(sample_at({60, 100})), NearColours::kAny);
  NearColours transparent(test::wish_for(test::picture(64, 64, [](Vec2) { return Texel{}; }), greys(200)), 20);
  transparent.start(all);
  EXPECT_EQ(transparent.list_for(sample_at({20, 20})), NearColours::kAny);
  NearColours light(test::wish_for(halves(), greys(1000), 0.2f), 20);
  light.start(StanceTable(CollageSettings(), 1000));
  EXPECT_GT(light.length(), 500u) << "the less colour counts, the more shapes come into question";
}

}  // namespace test_colour_target
}  // namespace tessera
