// The candidates that may stand as pieces, judged by their terms.
#include "master/rules/acceptance.h"

#include <gtest/gtest.h>

#include "core/settings/tuning.h"

namespace tessera::master {
namespace test_acceptance {

constexpr float kScale_px = 20;
constexpr float kArea_px2 = kScale_px * kScale_px;
constexpr float kPerimeter = 4;

Candidate touching_candidate(float part_of_least) {
  Candidate c;
  c.canvas_from_shape = {kScale_px, 0, 100, 100};
  c.perimeter = kPerimeter;
  c.terms.matched_px = part_of_least * kLeastMatched * kPerimeter * kScale_px;
  return c;
}

TEST(Acceptance, WhatOverlapsMuchOrTouchesNothingIsNotAcceptable) {
  Candidate c = touching_candidate(1.01f);
  EXPECT_TRUE(acceptable(c));
  c.terms.overlap_px2 = 1.01f * kMaxOverlap * kArea_px2;
  EXPECT_FALSE(acceptable(c));
  EXPECT_TRUE(touches(c));
  c = touching_candidate(0.99f);
  EXPECT_FALSE(acceptable(c));
  EXPECT_TRUE(overlaps_little(c));
}

TEST(Acceptance, ExactAreasMayNotShowMuchOverlapWithoutPadding) {
  const Candidate c = touching_candidate(1.01f);
  EXPECT_TRUE(overlaps_little(c, {0.99f * kMaxOverlap * kArea_px2, 0}, 0));
  EXPECT_FALSE(overlaps_little(c, {1.01f * kMaxOverlap * kArea_px2, 0}, 0));
  EXPECT_TRUE(overlaps_little(c, {kArea_px2, 0}, 2)) << "with padding";
}

}  // namespace test_acceptance
}  // namespace tessera::master
