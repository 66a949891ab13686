// Keep-out zones: the distance to them, and the canvas that they leave.
#include "core/field/keep_out.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/field/field_lookup.h"

namespace tessera {
namespace test_keep_out {

KeepOutRectangle rectangle(Vec2 middle_px, Vec2 half_size_px, float turned_rad = 0, float corner_px = 0) {
  return {middle_px, half_size_px, {std::cos(turned_rad), std::sin(turned_rad)}, corner_px};
}

/// A coverage map of the canvas in cells of half a px: 1 inside the window `cells`.
Grid<float> coverage(const Canvas& canvas, const Window& cells) {
  Grid<float> covered(2 * canvas.width_px, 2 * canvas.height_px, 0.f);
  for (int y = cells.y0; y < cells.y1; ++y) {
    for (int x = cells.x0; x < cells.x1; ++x) covered(x, y) = 1;
  }
  return covered;
}

float at(const CanvasField& field, Vec2 p) { return field_value(FieldView(field), p); }

TEST(KeepOutRectangle, DistancesAreThoseToItsSidesAndCorners) {
  const KeepOutRectangle zone = rectangle({50, 40}, {20, 10});
  EXPECT_FLOAT_EQ(distance_px(zone, {50, 40}), -10);
  EXPECT_FLOAT_EQ(distance_px(zone, {67, 40}), -3);
  EXPECT_FLOAT_EQ(distance_px(zone, {50, 55}), 5);
  EXPECT_FLOAT_EQ(distance_px(zone, {73, 54}), 5);  // 3 beside and 4 below the corner
}

TEST(KeepOutRectangle, TurnsClockwiseOnThePicture) {
  const KeepOutRectangle zone = rectangle({50, 40}, {20, 5}, 0.7853982f);
  EXPECT_NEAR(distance_px(zone, {50 + 14, 40 + 14}), -0.2f, 0.01f) << "its right end lies below";
  EXPECT_GT(distance_px(zone, {50 + 14, 40 - 14}), 14);
}

TEST(KeepOutRectangle, WithTheLargestCornersItsEndsAreRound) {
  const KeepOutRectangle disc = rectangle({50, 40}, {20, 20}, 0.3f, 1000);
  for (float angle = 0; angle < 6; angle += 0.5f) {
    EXPECT_NEAR(distance_px(disc, {50 + 30 * std::cos(angle), 40 + 30 * std::sin(angle)}), 10, 1e-4f);
  }
  EXPECT_FLOAT_EQ(distance_px(disc, {50, 40}), -20);
}

TEST(KeepOut, TheNearestOfSeveralRectanglesCounts) {
  const Canvas canvas = make_rectangle_canvas(100, 80);
  const CanvasField zones = distance_to({rectangle({20, 40}, {10, 10}), rectangle({80, 40}, {10, 10})}, canvas);
  EXPECT_NEAR(at(zones, {45, 40}), 15, 1e-4f);
  EXPECT_NEAR(at(zones, {60, 40}), 10, 1e-4f);
}

TEST(KeepOut, RectanglesAndMasksAgree) {
  const Canvas canvas = make_rectangle_canvas(100, 80);
  const CanvasField exact = distance_to({rectangle({50, 40}, {20, 10})}, canvas);
  const CanvasField drawn = distance_to(coverage(canvas, {60, 60, 140, 100}), canvas);
  for (const Vec2 p : {Vec2{50, 40}, Vec2{5, 5}, Vec2{72, 38}, Vec2{66, 50}, Vec2{99, 79}}) {
    EXPECT_NEAR(at(drawn, p), at(exact, p), 0.3f) << p.x << " " << p.y;
  }
}

TEST(KeepOut, OfManyRectanglesTheNearestCountsEverywhere) {
  const Canvas canvas = make_rectangle_canvas(150, 110);
  std::vector<KeepOutRectangle> zones;
  for (int i = 0; i < 60; ++i) {
    zones.push_back(
        rectangle({float(37 * i % 150), float(53 * i % 110)}, {1.f + float(i % 5), 2}, float(i), float(i % 3)));
  }
  const CanvasField distance = distance_to(zones, canvas);
  for (int y = 0; y < distance.value.height(); ++y) {
    for (int x = 0; x < distance.value.width(); ++x) {
      float nearest = kNoEdge_px;
      for (const KeepOutRectangle& zone : zones) {
        nearest = std::min(nearest, distance_px(zone, distance.origin + Vec2{float(x), float(y)}));
      }
      ASSERT_EQ(distance.value(x, y), nearest) << x << " " << y;
    }
  }
}

TEST(KeepOut, RepeatsWhereTheCanvasDoes) {
  const Canvas canvas = make_seamless_canvas(100, 80, true, false);
  const CanvasField exact = distance_to({rectangle({-2, 40}, {10, 10})}, canvas);
  const CanvasField drawn = distance_to(coverage(canvas, {0, 60, 16, 100}), canvas);
  EXPECT_NEAR(at(exact, {80, 40}), 8, 1e-4f);
  EXPECT_NEAR(at(drawn, {95, 40}), 5, 0.3f);
  EXPECT_GT(at(exact, {50, 79}), 30) << "not from above to below";
}

TEST(KeepOut, IsTakenOutOfTheCanvasAndItsRegions) {
  Canvas canvas = make_rectangle_canvas(100, 80);
  canvas.regions = {{canvas.distance, 8000}, {canvas.distance, 8000}};
  take_out(distance_to({rectangle({50, 40}, {20, 10})}, canvas), canvas);
  EXPECT_NEAR(canvas.area_px2, 100 * 80 - 40 * 20, 2);
  EXPECT_NEAR(canvas.regions[1].area_px2, 100 * 80 - 40 * 20, 2);
  EXPECT_TRUE(canvas.has_zones());
  for (const CanvasField& field : {canvas.distance, canvas.regions[0].distance, canvas.regions[1].distance}) {
    EXPECT_NEAR(at(field, {50, 40}), -10, 0.6f);
    EXPECT_NEAR(at(field, {50, 55}), 5, 1e-4f);
    EXPECT_NEAR(at(field, {3, 40}), 3, 1e-4f) << "the canvas' own edge";
  }
  take_out(distance_to({rectangle({10, 10}, {10, 10})}, canvas), canvas);
  EXPECT_NEAR(canvas.area_px2, 100 * 80 - 40 * 20 - 20 * 20, 2);
  EXPECT_NEAR(at(canvas.keep_out, {50, 40}), -10, 0.6f) << "besides those that it had";
}

TEST(KeepOut, OverlappingZonesCountOnce) {
  Canvas canvas = make_rectangle_canvas(100, 80);
  take_out(distance_to({rectangle({50, 40}, {20, 10}), rectangle({60, 40}, {20, 10})}, canvas), canvas);
  EXPECT_NEAR(canvas.area_px2, 100 * 80 - 50 * 20, 2);
}

}  // namespace test_keep_out
}  // namespace tessera
