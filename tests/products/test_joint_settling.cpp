// The joint settling of pieces beside each other, and the growth with which they meet.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cut_pieces.h"
#include "products/puzzle/laying/joint_settling.h"
#include "products/puzzle/pieces/growth_between.h"

namespace tessera {
namespace test_joint_settling {

TEST(GrowthBetween, IsWhatTabsHaveLost) {
  for (const float lost : {0.f, 0.8f, 1.6f}) {
    const CutPieces cut(12, CutStyle::tabs, lost);
    const std::size_t other = cut.neighbour_of(0);
    ASSERT_NE(other, 0u);
    const auto shifted = growth_between(cut.posed(0, {1, 0, 0.7f, -0.6f}), cut.posed(other), cut.scale);
    ASSERT_TRUE(shifted);
    EXPECT_NEAR(shifted->distance, lost, 0.15);
    EXPECT_LT(shifted->rms, 0.2 + 0.3 * double(lost)) << "corners lose otherwise than sides";
  }
}

TEST(GrowthBetween, SharesTheGapWithTheShiftAlongAStraightLineAndIsNothingFarAway) {
  const CutPieces cut(12, CutStyle::rectangles, 1);
  const auto along = growth_between(cut.posed(0), cut.posed(1), cut.scale);
  ASSERT_TRUE(along);
  EXPECT_NEAR(along->distance, 0.4, 0.25) << "a shift and the distance share the gap";
  EXPECT_FALSE(growth_between(cut.posed(0, {1, 0, 5'000, 0}), cut.posed(1), cut.scale));
}

/// The largest distance of a piece's centre from its right place.
float farthest_off(const std::vector<PosedPiece>& pieces) {
  float farthest = 0;
  for (const PosedPiece& piece : pieces)
    farthest = std::max(farthest, norm(piece.pose.apply(piece.piece->centre) - piece.piece->centre));
  return farthest;
}

/// Small errors of each row and column add up to a large one that no pair of neighbours shows.
TEST(JointSettling, TakesOutWhatRunsThroughAllPieces) {
  const CutPieces cut(98, CutStyle::tabs, 0);
  std::vector<PosedPiece> pieces;
  for (std::size_t i = 0; i < cut.pieces.size(); ++i)
    pieces.push_back(cut.posed(i, {1, 0, 0.006f * cut.pieces[i].centre.x, -0.004f * cut.pieces[i].centre.y}));
  pieces.front().pose = {1, 0, 0, 0};
  ASSERT_GT(farthest_off(pieces), 4);
  int told = 0;
  settle_jointly(pieces, cut.scale, 3, [&] { ++told; });
  EXPECT_LT(farthest_off(pieces), 0.5);
  EXPECT_EQ(told, 3);
  EXPECT_EQ(pieces.front().pose, (Similarity{1, 0, 0, 0}));
}

TEST(JointSettling, WhatIsAloneStays) {
  const CutPieces cut(12, CutStyle::polygons, 0);
  const Similarity away{0, 1, 9'000, 100};
  std::vector<PosedPiece> pieces = {cut.posed(0), cut.posed(1, away)};
  settle_jointly(pieces, cut.scale, 3, [] {});
  EXPECT_NEAR(pieces[1].pose.tx, away.tx, 1e-3);
  EXPECT_NEAR(pieces[1].pose.b, 1, 1e-6);
}

/// The pieces have no pictures here, so only the boundaries count.
float agreement(const CutPieces& cut, std::size_t i, std::size_t j, Vec2 shift) {
  std::vector<Beside> beside(cut.pieces[i].points.size(), Beside::nothing);
  return see_neighbour(cut.posed(i, {1, 0, shift.x, shift.y}), cut.posed(j), cut.scale, beside);
}

TEST(SeeNeighbour, BendsThatRunCloseSpeakForAPlaceAndThoseApartAgainstIt) {
  const CutPieces cut(12, CutStyle::tabs, 0);
  const std::size_t other = cut.neighbour_of(0);
  EXPECT_GT(agreement(cut, 0, other, {}), 20);
  const float apart = 0.6f * cut.scale.tolerance;
  EXPECT_LT(agreement(cut, 0, other, {apart, apart}), -20);
}

TEST(SeeNeighbour, StraightLinesSayNothingByHowCloseTheyRun) {
  const CutPieces cut(12, CutStyle::rectangles, 0);
  // The small value comes from the corners; the whole side is four times as long.
  for (const float times : {0.f, 0.6f}) EXPECT_NEAR(agreement(cut, 0, 1, {times * cut.scale.tolerance, 0}), 0, 32);
}

}  // namespace test_joint_settling
}  // namespace tessera
