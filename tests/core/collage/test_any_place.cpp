// The search for a place of a shape on an empty canvas.
#include <gtest/gtest.h>

#include <cmath>

#include "core/collage/any_place.h"
#include "core/field/keep_out.h"

namespace tessera {
namespace test_any_place {

constexpr DirectionRange kAnyRotation;

/// A bar of area 1, `aspect` times as long as wide.
Outline bar(float aspect) {
  const float width = 1 / std::sqrt(aspect);
  const Vec2 half{0.5f * aspect * width, 0.5f * width};
  Outline outline;
  std::vector<Vec2> curve;
  const Vec2 corners[] = {{-half.x, -half.y}, {half.x, -half.y}, {half.x, half.y}, {-half.x, half.y}};
  for (int side = 0; side < 4; ++side) {
    const Vec2 from = corners[side], to = corners[(side + 1) % 4];
    for (int i = 0; i < 32; ++i) curve.push_back(from + (to - from) * (float(i) / 32));
  }
  outline.curves.push_back(curve);
  return outline;
}

/// Returns whether a bar `length_px` long has a place.
bool fits(const Canvas& canvas, float length_px, const DirectionRange& rotations, float kept_px = 0) {
  constexpr float kAspect = 16;
  return has_any_place(bar(kAspect), length_px / std::sqrt(kAspect), rotations,
                       {canvas.distance, canvas.period, kept_px});
}

TEST(AnyPlace, ABarFitsAsLongAsTheCanvasIsThatWay) {
  const Canvas canvas = make_rectangle_canvas(400, 200);
  const DirectionRange upright = direction_range(0, 0);
  const DirectionRange quarter = direction_range(1.5707964f, 1.5707964f);
  EXPECT_TRUE(fits(canvas, 390, upright));
  EXPECT_FALSE(fits(canvas, 430, upright));
  EXPECT_TRUE(fits(canvas, 190, quarter));
  EXPECT_FALSE(fits(canvas, 230, quarter));
  EXPECT_TRUE(fits(canvas, 415, kAnyRotation)) << "along the diagonal";
  EXPECT_FALSE(fits(canvas, 470, kAnyRotation));
}

TEST(AnyPlace, PaddingAndZonesTakeRoom) {
  Canvas canvas = make_rectangle_canvas(400, 200);
  EXPECT_TRUE(fits(canvas, 300, kAnyRotation, 40));
  EXPECT_FALSE(fits(canvas, 300, kAnyRotation, 90));
  take_out(distance_to({{{200, 100}, {40, 100}, {1, 0}, 0}}, canvas), canvas);  // a wall in the middle
  EXPECT_TRUE(fits(canvas, 150, kAnyRotation));
  EXPECT_FALSE(fits(canvas, 300, kAnyRotation));
}

TEST(AnyPlace, OnASeamlessCanvasNothingReachesItself) {
  const Canvas canvas = make_seamless_canvas(200, 200, true, true);
  EXPECT_TRUE(fits(canvas, 150, kAnyRotation));
  EXPECT_FALSE(fits(canvas, 450, kAnyRotation));
}

}  // namespace test_any_place
}  // namespace tessera
