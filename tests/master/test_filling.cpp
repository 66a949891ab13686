// When the region counts as full.
#include <gtest/gtest.h>

#include "master/filling.h"
#include "offering_matcher.h"

namespace tessera::master {
namespace {

using test::piece;

const std::vector<Shape>& library() {
  static const std::vector<Shape> shapes = test::synthetic_library(4);
  return shapes;
}

CollageSettings settings() {
  CollageSettings s;
  s.pieces.min_scale_px = 20;
  s.pieces.max_scale_px = 90;
  return s;
}

class FillingTest : public testing::Test {
 protected:
  explicit FillingTest(const CollageSettings& s = settings())
      : context_(make_matching_context(s, std::uint32_t(library().size()))),
        collage_(canvas_, s, context_, shapes_),
        filling_(collage_, context_, s, matcher_, statistics_) {}

  const Canvas canvas_ = make_rectangle_canvas(200, 140);
  MatchingContext context_;
  test::VectorShapes shapes_{library()};
  Collage collage_;
  test::OfferingMatcher matcher_{library()};
  RunStatistics statistics_;
  Filling filling_;
};

TEST_F(FillingTest, AsksTwiceMoreBeforeTheRegionIsFull) {
  EXPECT_FALSE(filling_.place_one());
  EXPECT_EQ(matcher_.questions, 3);
}

TEST_F(FillingTest, WhatIsFoundAtTheLastMomentIsPlacedAndAllBeginsAnew) {
  matcher_.offers = {{}, {}, piece(1, 40, test::centre_at_upper_left(library()[1], 40))};
  EXPECT_TRUE(filling_.place_one());
  EXPECT_EQ(collage_.placements().size(), 1u);
  matcher_.questions = 0;
  matcher_.offers = {{}, {}, piece(2, 40, test::centre_at_lower_right(library()[2], 40, {200, 140}))};
  EXPECT_TRUE(filling_.place_one());
  EXPECT_EQ(matcher_.questions, 3);
  EXPECT_EQ(collage_.placements().size(), 2u);
}

class WithoutTangentDockings : public FillingTest {
 protected:
  static CollageSettings only_pairs() {
    CollageSettings s = settings();
    s.match.tangent_dockings = 0;
    return s;
  }
  WithoutTangentDockings() : FillingTest(only_pairs()) {}
};

/// The same question would give the same answer.
TEST_F(WithoutTangentDockings, AsksOnce) {
  EXPECT_FALSE(filling_.place_one());
  EXPECT_EQ(matcher_.questions, 1);
}

}  // namespace
}  // namespace tessera::master
