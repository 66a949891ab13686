// The shapes that may replace pieces taken out of a collage, and the places that count as the same.
#include "core/collage/former_pieces.h"

#include <gtest/gtest.h>

namespace tessera {
namespace test_former_pieces {

constexpr TakenOut kFirst{ShapeId{0}, 0};
const std::vector<std::uint32_t> kOwn = {0, 1, 2};

bool others(const CollageSettings& settings, const TakenOut& piece = kFirst,
            const std::vector<std::uint32_t>& silhouettes = kOwn, const std::vector<std::uint32_t>& drawings = kOwn) {
  return may_be_replaced({piece}, settings, silhouettes, drawings).front();
}

/// Settings with two classes: the first shape's, and that of the two others.
CollageSettings with_classes(const ShapeWish& first, const ShapeWish& others) {
  CollageSettings s;
  s.wishes.classes = {first, others};
  s.wishes.class_of_shape = {0, 1, 1};
  return s;
}

TEST(FormerPieces, LieWithinHalfTheSizeWhereTheyLay) {
  const Similarity then{0, 40, 100, 50};
  EXPECT_TRUE(is_at_former_place(then, {3, 0, 119, 50}, {}));
  EXPECT_FALSE(is_at_former_place(then, {3, 0, 121, 50}, {}));
  EXPECT_FALSE(is_at_former_place(then, {60, 0, 100, 71}, {}));
}

TEST(FormerPieces, LieWhereTheyLayAcrossASeam) {
  const Period period{200, 0};
  EXPECT_TRUE(is_at_former_place({40, 0, 195, 50}, {40, 0, 4, 50}, period));
  EXPECT_FALSE(is_at_former_place({40, 0, 195, 50}, {40, 0, 4, 50}, {}));
}

TEST(FormerPieces, OthersComeInFromALibraryOfSeveral) { EXPECT_TRUE(others({})); }

TEST(FormerPieces, NoOthersComeInWhereAllLookAlike) {
  EXPECT_FALSE(others({}, kFirst, {0, 0, 0}));
  EXPECT_FALSE(others({}, kFirst, {0, 0}, {0, 0}));
}

TEST(FormerPieces, NoOthersComeInThatMayNotStand) {
  ShapeWish never;
  never.weight = 0;
  EXPECT_FALSE(others(with_classes({}, never)));
  EXPECT_TRUE(others(with_classes(never, {})));
}

TEST(FormerPieces, NoOthersComeInThatAreUsedUp) {
  CollageSettings s;
  s.pieces.uses = 1;
  s.wishes.given = {{ShapeId{1}, {}}};
  EXPECT_TRUE(others(s));
  s.wishes.given.push_back({ShapeId{2}, {}});
  EXPECT_FALSE(others(s));
  EXPECT_TRUE(may_be_replaced({{ShapeId{1}, 0}}, s, kOwn, kOwn).front()) << "the first one may";
}

/// A piece of the shape's mirror image counts as one of the shape.
TEST(FormerPieces, NoOthersComeInForWhatMustStandAgain) {
  CollageSettings s;
  s.pieces.least_uses = 1;
  EXPECT_FALSE(others(s));
  s.wishes.given = {{ShapeId{2}, {}}};
  EXPECT_FALSE(others(s));
  EXPECT_TRUE(others(s, kFirst, {0, 1, 0}, {0, 1, 0}));
}

TEST(FormerPieces, OthersOfItsRegionComeIn) {
  ShapeWish right;
  right.in_region = {0, 1};
  CollageSettings s = with_classes({}, right);
  s.wishes.regions.resize(2);
  EXPECT_FALSE(others(s, {ShapeId{0}, 0}));
  EXPECT_TRUE(others(s, {ShapeId{0}, 1}));
}

}  // namespace test_former_pieces
}  // namespace tessera
