// The moment when a region counts as full.
#include <gtest/gtest.h>

#include "offered_filling.h"

namespace tessera::master {
namespace test_filling {

using test::piece;

using FillingTest = test::OfferedFilling;

TEST_F(FillingTest, SearchesEachSampleBeforeTheRegionIsFull) {
  EXPECT_FALSE(filling_.place_one());
  EXPECT_EQ(matcher_.samples_asked, std::vector<std::size_t>(1 + kSearches, collage_.open_samples()));
}

class WideFillingTest : public FillingTest {
 protected:
  WideFillingTest() : FillingTest(settings(), make_rectangle_canvas(1200, 800)) {}
};

/// The piece is found in the second search of all samples, so one more search of all is left.
TEST_F(WideFillingTest, APieceMakesOnlyTheSamplesNearItBeSearchedAnew) {
  matcher_.offers = {{}, {}, piece(1, 40, test::centre_at_upper_left(library()[1], 40))};
  EXPECT_TRUE(filling_.place_one());
  matcher_.samples_asked.clear();
  EXPECT_FALSE(filling_.place_one());
  const std::size_t all = collage_.open_samples();
  ASSERT_EQ(matcher_.samples_asked.size(), 4u);
  const std::size_t renewed = matcher_.samples_asked.front();
  EXPECT_LT(renewed, all);
  EXPECT_EQ(matcher_.samples_asked, (std::vector{renewed, renewed, renewed, all}));
}

TEST_F(FillingTest, WhatIsFoundAtTheLastMomentIsPlaced) {
  matcher_.offers = {{}, {}, piece(1, 40, test::centre_at_upper_left(library()[1], 40))};
  EXPECT_TRUE(filling_.place_one());
  EXPECT_EQ(collage_.placements().size(), 1u);
  matcher_.questions = 0;
  matcher_.offers = {{}, {}, piece(2, 40, test::centre_at_lower_right(library()[2], 40, {200, 140}))};
  EXPECT_TRUE(filling_.place_one());
  EXPECT_EQ(matcher_.questions, 3);
  EXPECT_EQ(collage_.placements().size(), 2u);
}

/// A library with line art in its last place. Gaps are compared with 64 of its open shapes, which differ from piece to piece.
class ManyShapesFillingTest : public FillingTest {
 protected:
  static const std::vector<Shape>& many_shapes() {
    static const std::vector<Shape> shapes = [] {
      std::vector<Shape> discs(70, test::make_library_shape("disc", test::disc_outline()));
      discs.back() = test::make_library_shape("spectacles", test::spectacles_outline(0.2f));
      return discs;
    }();
    return shapes;
  }
  ManyShapesFillingTest() : FillingTest(settings(), make_rectangle_canvas(200, 140), many_shapes()) {}
};

/// The first 64 shapes say that no gap is wide. With one piece more the line art is among those that are compared, and one
/// more search follows. A run that went on from a checkpoint would see it, too.
TEST_F(ManyShapesFillingTest, WhetherAWideGapIsLeftIsAskedAfterEachPiece) {
  matcher_.offers = {{}, {}, piece(1, 40, test::centre_at_upper_left(many_shapes()[1], 40))};
  EXPECT_TRUE(filling_.place_one());
  matcher_.samples_asked.clear();
  filling_.place_one();
  EXPECT_EQ(matcher_.samples_asked.size(), std::size_t(1 + kSearches + 1));
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

}  // namespace test_filling
}  // namespace tessera::master
