// The cost of wrong colours in improving.
#include "master/off_colour.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/matching/colour_fit.h"
#include "core/settings/tuning.h"
#include "support/colours.h"
#include "whole_collage.h"

namespace tessera::master {
namespace test_off_colour {

const Lab kDark{15, 0, 0};
const Lab kLight{90, 0, 0};

/// A library whose first shape is dark and whose second shape is light.
std::vector<Shape> dark_and_light() {
  std::vector<Shape> shapes = whole_collage::library();
  shapes.resize(2);
  shapes[0].colour_grid = test::two_toned_grid(kDark, kDark);
  shapes[1].colour_grid = test::two_toned_grid(kLight, kLight);
  return shapes;
}

ColourWish dark_wish(float weight) {
  return test::wish_for(test::picture(200, 200, [](Vec2) { return test::opaque(kDark); }), {kDark, kLight}, weight);
}

const Placement kDarkPiece{ShapeId(0), {30, 0, 60, 100}, 0, 0};
const Placement kLightPiece{ShapeId(1), {0, 20, 140, 100}, 0, 0};

TEST(OffColour, IsAreaTimesDifferenceTimesWeight) {
  const std::vector<Shape> shapes = dark_and_light();
  test::VectorShapes source(shapes);
  const ColourWish wish = dark_wish(4);
  OffColour off(wish, source);
  EXPECT_LT(off.loss_256ths_px2({kDarkPiece}), 4 * 256) << "it has the colour of what it covers";
  const float difference =
      colour_difference(source.model(ShapeId(1)).colour, kLightPiece.canvas_from_shape, *wish.target);
  EXPECT_NEAR(double(off.loss_256ths_px2({kLightPiece})), 256 * kOffColour * 4 * 400 * double(difference), 1);
  EXPECT_GT(off.loss_256ths_px2({kLightPiece}), 200 * 256) << "a hole of half its size costs less";
}

TEST(OffColour, OfSeveralIsTheirSumInAnyOrderAndAskedAgain) {
  const std::vector<Shape> shapes = dark_and_light();
  test::VectorShapes source(shapes);
  OffColour off(dark_wish(1), source);
  std::vector<Placement> pieces = {kDarkPiece, kLightPiece, kLightPiece};
  pieces[2].canvas_from_shape.tx = 30;
  std::int64_t sum = 0;
  for (const Placement& p : pieces) sum += off.loss_256ths_px2({p});
  EXPECT_EQ(off.loss_256ths_px2(pieces), sum);
  std::reverse(pieces.begin(), pieces.end());
  EXPECT_EQ(off.loss_256ths_px2(pieces), sum);
  pieces[0].canvas_from_shape = {10, 0, 30, 100};
  EXPECT_LT(off.loss_256ths_px2(pieces), sum) << "the smaller piece costs less, whatever was known of its place";
}

TEST(OffColour, CostsNothingWithoutAWish) {
  const std::vector<Shape> shapes = dark_and_light();
  test::VectorShapes source(shapes);
  EXPECT_EQ(OffColour({}, source).loss_256ths_px2({kLightPiece}), 0);
  EXPECT_EQ(OffColour(dark_wish(0), source).loss_256ths_px2({kLightPiece}), 0);
}

}  // namespace test_off_colour
}  // namespace tessera::master
