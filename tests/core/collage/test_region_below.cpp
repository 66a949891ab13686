// The region in which a piece lies.
#include "core/collage/region_below.h"

#include <gtest/gtest.h>

#include "support/synthetic_shapes.h"

namespace tessera {
namespace test_region_below {

/// A canvas of 200 x 100 px with two regions that meet in the middle.
Canvas halves() {
  Canvas canvas = make_rectangle_canvas(200, 100);
  for (const bool right : {false, true}) {
    Grid<float> coverage(200, 100, 0.f);
    for (int y = 0; y < 100; ++y) {
      for (int x = 0; x < 200; ++x) coverage(x, y) = float((x >= 100) == right);
    }
    const Canvas part = make_mask_canvas(coverage, 1);
    canvas.regions.push_back({part.distance, part.area_px2});
  }
  return canvas;
}

TEST(RegionBelow, IsThatWithMostOfThePiece) {
  const Canvas canvas = halves();
  const Outline square = test::make_test_shape("square", test::rectangle_outline(1, 1)).outline;
  EXPECT_EQ(region_below(canvas, square, {40, 0, 50, 50}), 0u);
  EXPECT_EQ(region_below(canvas, square, {40, 0, 150, 50}), 1u);
  EXPECT_EQ(region_below(canvas, square, {40, 0, 97, 50}), 0u);
  EXPECT_EQ(region_below(canvas, square, {40, 0, 103, 50}), 1u);
}

TEST(RegionBelow, IsTheFirstWhereNoneHasAny) {
  const Outline square = test::make_test_shape("square", test::rectangle_outline(1, 1)).outline;
  EXPECT_EQ(region_below(halves(), square, {40, 0, 500, 50}), 0u);
  EXPECT_EQ(region_below(make_rectangle_canvas(200, 100), square, {40, 0, 150, 50}), 0u);
}

}  // namespace test_region_below
}  // namespace tessera
