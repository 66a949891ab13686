// The room that is filled again where pieces were taken out.
#include "core/field/room.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tessera {
namespace test_room {

/// A square from -0.5 to 0.5 both ways.
const Outline& square() {
  static const Outline outline{{{{-0.5f, -0.5f}, {0.5f, -0.5f}, {0.5f, 0.5f}, {-0.5f, 0.5f}}}};
  return outline;
}

RemovedPiece square_at(float x, float y, float size) { return {&square(), {size, 0, x, y}}; }

float at(const CanvasField& field, Vec2 p) {
  return field.value(int(std::lround(p.x - field.origin.x)), int(std::lround(p.y - field.origin.y)));
}

TEST(Room, IsWhereThePiecesLayAndALittleAround) {
  Canvas canvas = make_rectangle_canvas(200, 150);
  const CanvasField before = canvas.distance;
  limit_regions_to_room({square_at(60, 70, 40), square_at(150, 75, 20)}, 8, canvas);
  ASSERT_EQ(canvas.regions.size(), 1u);
  const CanvasField& room = canvas.regions[0].distance;
  EXPECT_NEAR(at(room, {60.5f, 70.5f}), 28, 1) << "20 to where it ended, and 8";
  EXPECT_NEAR(at(room, {84.5f, 70.5f}), 8 - 4.5f, 0.6f);
  EXPECT_EQ(at(room, {100.5f, 70.5f}), -1) << "away from it";
  EXPECT_GT(at(room, {150.5f, 75.5f}), 15);
  EXPECT_NEAR(canvas.regions[0].area_px2, 40 * 40 + 4 * 40 * 8 + 20 * 20 + 4 * 20 * 8 + 2 * 3.1416 * 64, 30);
  EXPECT_EQ(canvas.distance.value.data(), before.value.data()) << "the canvas itself stays";
  EXPECT_EQ(canvas.area_px2, 200 * 150);
}

TEST(Room, DoesNotReachBeyondTheCanvas) {
  Canvas canvas = make_rectangle_canvas(200, 150);
  limit_regions_to_room({square_at(10, 75, 40)}, 8, canvas);
  const CanvasField& room = canvas.regions[0].distance;
  EXPECT_LT(at(room, {-0.5f, 75.5f}), 0);
  EXPECT_NEAR(at(room, {5.5f, 75.5f}), 5.5, 0.1) << "to the edge";
}

TEST(Room, GoesAcrossASeam) {
  Canvas canvas = make_seamless_canvas(200, 150, true, false);
  limit_regions_to_room({square_at(195, 75, 40)}, 4, canvas);
  const CanvasField& room = canvas.regions[0].distance;
  EXPECT_GT(at(room, {10.5f, 75.5f}), 0);
  EXPECT_GT(at(room, {180.5f, 75.5f}), 0);
  EXPECT_LT(at(room, {60.5f, 75.5f}), 0);
}

/// Each region is filled by itself, as before.
TEST(Room, IsTakenOfEachRegion) {
  Canvas canvas = make_rectangle_canvas(200, 150);
  CanvasField left = canvas.distance, right = canvas.distance;
  for (int y = 0; y < left.value.height(); ++y) {
    for (int x = 0; x < left.value.width(); ++x) {
      const float beyond_middle_px = left.origin.x + float(x) - 100;
      left.value(x, y) = std::min(left.value(x, y), -beyond_middle_px);
      right.value(x, y) = std::min(right.value(x, y), beyond_middle_px);
    }
  }
  canvas.regions = {{left, 15000}, {right, 15000}};
  limit_regions_to_room({square_at(100, 70, 40)}, 0, canvas);
  ASSERT_EQ(canvas.regions.size(), 2u);
  for (const CanvasRegion& region : canvas.regions) EXPECT_NEAR(region.area_px2, 20 * 40, 40);
  EXPECT_LT(at(canvas.regions[0].distance, {110.5f, 70.5f}), 0);
  EXPECT_GT(at(canvas.regions[1].distance, {110.5f, 70.5f}), 0);
}

/// Pieces that lay side by side leave one room, without a wall between them.
TEST(Room, OfNeighboursIsOne) {
  Canvas canvas = make_rectangle_canvas(300, 150);
  limit_regions_to_room({square_at(100, 70, 40), square_at(140, 70, 40), square_at(260, 70, 20)}, 5, canvas);
  EXPECT_NEAR(at(canvas.regions[0].distance, {120.5f, 70.5f}), 25, 1);
  EXPECT_LT(at(canvas.regions[0].distance, {200.5f, 70.5f}), 0);
}

/// The canvas has one cell per px.
TEST(Room, MayBeAsLargeAsTheCanvas) {
  Canvas canvas = make_rectangle_canvas(3000, 100);
  limit_regions_to_room({square_at(1500, 50, 4000)}, 8, canvas);
  EXPECT_NEAR(canvas.regions[0].area_px2, 3000 * 100, 1);
  EXPECT_NEAR(at(canvas.regions[0].distance, {1500.5f, 30.5f}), 30.5, 0.1) << "to the canvas' edge";
}

TEST(Room, OfPiecesOutsideTheCanvasThereIsNone) {
  Canvas canvas = make_rectangle_canvas(200, 150);
  limit_regions_to_room({square_at(-100, 70, 40)}, 8, canvas);
  EXPECT_EQ(canvas.regions[0].area_px2, 0);
}

}  // namespace test_room
}  // namespace tessera
