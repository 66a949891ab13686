// The pieces that a finished collage lacks.
#include <gtest/gtest.h>

#include "core/collage/missing_pieces.h"

namespace tessera {
namespace test_missing_pieces {

std::vector<Placement> placed(const std::vector<std::uint32_t>& shapes) {
  std::vector<Placement> placements;
  for (const std::uint32_t shape : shapes) placements.push_back({ShapeId{shape}, {20, 0, 50, 50}, 1, 1});
  return placements;
}

std::vector<std::uint32_t> no_mirror_images() { return {0, 1, 2, 3}; }

/// Returns "shape: standing of wanted" for each missing shape, one after the other.
std::string missing(const CollageSettings& settings, const std::vector<std::uint32_t>& shapes,
                    const std::vector<std::uint32_t>& drawings = no_mirror_images()) {
  std::string text;
  for (const MissingPieces& m : missing_pieces(settings, drawings, placed(shapes))) {
    text += std::to_string(index_of(m.shape)) + ": " + std::to_string(m.standing) + " of " + std::to_string(m.wanted) +
            "; ";
  }
  return text;
}

TEST(MissingPieces, NoneWhereNothingIsCounted) {
  CollageSettings s;
  s.pieces.uses = 2;
  EXPECT_EQ(missing(s, {}), "");
}

TEST(MissingPieces, EachShapeAsOftenAsTheJobSays) {
  CollageSettings s;
  s.pieces.least_uses = s.pieces.uses = 2;
  EXPECT_EQ(missing(s, {0, 0, 1, 3, 3}), "1: 1 of 2; 2: 0 of 2; ");
  EXPECT_EQ(missing(s, {0, 0, 1, 1, 2, 2, 3, 3}), "");
}

TEST(MissingPieces, WithFitAllEachAtLeastOnce) {
  CollageSettings s;
  s.pieces.fit_all = true;
  EXPECT_EQ(missing(s, {0, 1, 1, 1}), "2: 0 of 1; 3: 0 of 1; ");
}

TEST(MissingPieces, AShapesOwnWishCountsAndWhatMayNotStandDoesNot) {
  CollageSettings s;
  s.pieces.least_uses = 1;
  s.wishes.classes.resize(4);
  s.wishes.classes[1].least_uses = 3;
  s.wishes.classes[2].weight = 0;
  s.wishes.classes[3].least_uses = 0;
  s.wishes.class_of_shape = {0, 1, 2, 3};
  EXPECT_EQ(missing(s, {0}), "1: 0 of 3; ");
}

/// A shape is required if it may stand in one of two regions, but not if it may stand in none.
TEST(MissingPieces, OneRegionIsEnough) {
  CollageSettings s;
  s.pieces.least_uses = 1;
  s.wishes.regions.resize(2);
  s.wishes.classes.resize(3);
  s.wishes.classes[1].in_region = {0, 1};
  s.wishes.classes[2].in_region = {0, 0};
  s.wishes.class_of_shape = {0, 1, 2, 0};
  EXPECT_EQ(missing(s, {0, 3}), "1: 0 of 1; ");
}

TEST(MissingPieces, AMirrorImageIsAPieceOfItsShape) {
  CollageSettings s;
  s.pieces.least_uses = 2;
  EXPECT_EQ(missing(s, {0, 2, 3, 3}, {0, 1, 0, 1}), "");
  EXPECT_EQ(missing(s, {0, 3, 3}, {0, 1, 0, 1}), "0: 1 of 2; ");
}

}  // namespace test_missing_pieces
}  // namespace tessera
