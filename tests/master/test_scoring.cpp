// The worth of a candidate beside the placed pieces.
#include "master/rules/scoring.h"

#include <gtest/gtest.h>

#include "core/settings/tuning.h"

namespace tessera::master {
namespace test_scoring {

constexpr ShapeId kShape{2};

CollageSettings settings() {
  CollageSettings s;
  s.pieces.uses = 2;
  s.objective.repetition_exponent = 1;
  s.objective.near_twin_factor = 0.5f;
  return s;
}

/// The scoring for a library of five shapes.
Scoring scoring_of(const CollageSettings& settings) { return Scoring(settings, StanceTable(settings, 5)); }

Placement placement_at(ShapeId shape, float scale_px, Vec2 centre) {
  return {shape, {scale_px, 0, centre.x, centre.y}, 1, 1};
}

/// A candidate of a shape of radius 1.
Candidate candidate_at(float scale_px, Vec2 centre) {
  Candidate c;
  c.shape = kShape;
  c.canvas_from_shape = {scale_px, 0, centre.x, centre.y};
  c.radius = 1;
  c.perimeter = 4;
  return c;
}

TEST(Scoring, AShapeMayBeUsedSoOften) {
  Scoring scoring = scoring_of(settings());
  for (int uses = 0; uses < 2; ++uses) {
    EXPECT_TRUE(scoring.may_use(kShape)) << uses;
    scoring.count(placement_at(kShape, 20, {50, 50}));
  }
  EXPECT_FALSE(scoring.may_use(kShape));
  EXPECT_TRUE(scoring.may_use(ShapeId{3}));
  scoring.forget_placements();
  EXPECT_TRUE(scoring.may_use(kShape));
}

TEST(Scoring, WithoutALimitAShapeMayAlwaysBeUsed) {
  Scoring scoring = scoring_of(CollageSettings{});
  for (int uses = 0; uses < 9; ++uses) scoring.count(placement_at(kShape, 20, {50, 50}));
  EXPECT_TRUE(scoring.may_use(kShape));
}

TEST(Scoring, AShapesOwnNumberOfUsesCounts) {
  CollageSettings s = settings();
  s.wishes.classes.resize(3);
  s.wishes.classes[1].uses = 1;
  s.wishes.classes[2].uses = 0;
  s.wishes.class_of_shape = {0, 0, 1, 2, 0};
  Scoring scoring = scoring_of(s);
  for (const std::uint32_t shape : {1u, 2u, 3u}) {
    for (int uses = 0; uses < 9 && scoring.may_use(ShapeId{shape}); ++uses)
      scoring.count(placement_at(ShapeId{shape}, 20, {}));
  }
  EXPECT_FALSE(scoring.may_use(ShapeId{1})) << "after two, as the job says";
  EXPECT_FALSE(scoring.may_use(kShape)) << "after one";
  EXPECT_TRUE(scoring.may_use(ShapeId{3})) << "0 = no limit";
}

TEST(Scoring, TheWeightOfTheStanceMultiplies) {
  CollageSettings s = settings();
  s.wishes.classes.resize(2);
  s.wishes.classes[1].weight = 2.5f;
  s.wishes.class_of_shape = {0, 0, 1, 0, 0};
  const Scoring scoring = scoring_of(s);
  Candidate candidate = candidate_at(40, {100, 100});
  candidate.terms.matched_px = 50;
  const float plain = scoring.score(candidate);
  EXPECT_GT(plain, 0);
  candidate.stance = 1;
  EXPECT_FLOAT_EQ(scoring.score(candidate), 2.5f * plain);
}

TEST(Scoring, RepetitionCosts) {
  Scoring scoring = scoring_of(settings());
  const Candidate far = candidate_at(20, {500, 500});
  EXPECT_FLOAT_EQ(scoring.preference(far), 1);
  scoring.count(placement_at(ShapeId{1}, 20, {50, 50}));
  EXPECT_FLOAT_EQ(scoring.preference(far), 1) << "another shape";
  scoring.count(placement_at(kShape, 20, {50, 50}));
  EXPECT_FLOAT_EQ(scoring.preference(far), 0.5f);
  scoring.count(placement_at(kShape, 20, {90, 50}));
  EXPECT_FLOAT_EQ(scoring.preference(far), 1.f / 3);
}

/// Shapes 1 and 2 are one silhouette in two colours.
TEST(Scoring, VariantsRepeatEachOther) {
  const std::vector<ShapeId> silhouettes{ShapeId{0}, ShapeId{1}, ShapeId{1}, ShapeId{3}, ShapeId{4}};
  Scoring scoring(settings(), StanceTable(settings(), 5), silhouettes);
  Candidate far = candidate_at(20, {500, 500}), near = candidate_at(20, {60, 50});
  scoring.count(placement_at(ShapeId{1}, 20, {50, 50}));
  EXPECT_FLOAT_EQ(scoring.preference(far), 1 / (1 + kUseInOtherColours)) << "in other colours";
  EXPECT_FLOAT_EQ(scoring.preference(near), 0.5f / (1 + kUseInOtherColours));
  far.shape = ShapeId{1};
  EXPECT_FLOAT_EQ(scoring.preference(far), 0.5f);
  EXPECT_TRUE(scoring.may_use(kShape));
  scoring.count(placement_at(kShape, 20, {90, 50}));
  EXPECT_TRUE(scoring.may_use(ShapeId{1})) << "uses are those of each drawing";
  scoring.count(placement_at(kShape, 20, {90, 50}));
  EXPECT_FALSE(scoring.may_use(kShape));
  EXPECT_TRUE(scoring.may_use(ShapeId{1}));
}

/// Shape 4 is the mirror image of shape 2.
TEST(Scoring, AMirrorImageIsAUseOfItsDrawing) {
  const std::vector<ShapeId> drawings{ShapeId{0}, ShapeId{1}, ShapeId{2}, ShapeId{3}, ShapeId{2}};
  Scoring scoring(settings(), StanceTable(settings(), 5), drawings, {}, drawings);
  Candidate far = candidate_at(20, {500, 500});
  scoring.count(placement_at(ShapeId{4}, 20, {50, 50}));
  EXPECT_FLOAT_EQ(scoring.preference(far), 0.5f) << "as if it stood itself";
  far.shape = ShapeId{4};
  EXPECT_FLOAT_EQ(scoring.preference(far), 0.5f);
  scoring.count(placement_at(kShape, 20, {90, 50}));
  EXPECT_FALSE(scoring.may_use(kShape)) << "two uses";
  EXPECT_FALSE(scoring.may_use(ShapeId{4}));
}

TEST(Scoring, AMirrorImageCoversOtherPlaces) {
  const std::vector<ShapeId> silhouettes{ShapeId{0}, ShapeId{1}, ShapeId{1}, ShapeId{3}, ShapeId{1}};
  const std::vector<ShapeId> drawings{ShapeId{0}, ShapeId{1}, ShapeId{2}, ShapeId{3}, ShapeId{2}};
  const Scoring scoring(settings(), StanceTable(settings(), 5), silhouettes, {}, drawings);
  EXPECT_TRUE(scoring.look_alike(ShapeId{1}, ShapeId{2})) << "in other colours";
  EXPECT_FALSE(scoring.look_alike(ShapeId{2}, ShapeId{4}));
  EXPECT_FALSE(scoring.look_alike(ShapeId{0}, ShapeId{3}));
}

/// Two pieces of 20 px and radius 1 are near within (1 + kNearTwinReach) * 40 px.
TEST(Scoring, NearTwinsCostMore) {
  Scoring scoring = scoring_of(settings());
  scoring.count(placement_at(kShape, 20, {100, 100}));
  const float reach_px = (1 + kNearTwinReach) * 40;
  EXPECT_FLOAT_EQ(scoring.preference(candidate_at(20, {100 + reach_px + 1, 100})), 0.5f);
  EXPECT_FLOAT_EQ(scoring.preference(candidate_at(20, {100 + reach_px - 1, 100})), 0.25f);
}

TEST(Scoring, NearTwinsAreNearAcrossASeam) {
  Scoring scoring(settings(), StanceTable(settings(), 5), {}, {300, 0});
  scoring.count(placement_at(kShape, 20, {10, 100}));
  EXPECT_FLOAT_EQ(scoring.preference(candidate_at(20, {290, 100})), 0.25f);
  EXPECT_FLOAT_EQ(scoring.preference(candidate_at(20, {150, 100})), 0.5f);
  EXPECT_FLOAT_EQ(scoring.preference(candidate_at(20, {10, 390})), 0.5f) << "no seam that way";
}

}  // namespace test_scoring
}  // namespace tessera::master
