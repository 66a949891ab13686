// Contours close, keep the larger values on their left, and lie where the interpolation puts them.
#include "core/geometry/contour.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <numbers>

#include "core/geometry/polygon.h"

namespace tessera {
namespace test_contour {

/// An antialiased disc: coverage falls from 1 to 0 within a node's width.
Grid<float> disc(int size, Vec2 centre, float radius) {
  Grid<float> value(size, size);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      value(x, y) = std::clamp(radius - norm(Vec2{float(x), float(y)} - centre) + 0.5f, 0.f, 1.f);
    }
  }
  return value;
}

Grid<float> any_grid() {
  Grid<float> value(*rc::gen::inRange(1, 12), *rc::gen::inRange(1, 12));
  for (float& v : value.data()) v = float(*rc::gen::inRange(0, 256)) / 255;
  return value;
}

bool is_inside(const std::vector<std::vector<Vec2>>& curves, Vec2 p) {
  bool inside = false;
  for (const auto& curve : curves) inside ^= contains(curve, p);
  return inside;
}

TEST(Contour, DiscHasItsAreaAndPlace) {
  const auto curves = contours(disc(100, {48.3f, 51.6f}, 30), 0.5f);
  ASSERT_EQ(curves.size(), 1u);
  const AreaMoment moment = area_moment(curves[0]);
  EXPECT_NEAR(moment.area, std::numbers::pi * 900, 2);
  EXPECT_NEAR(moment.x / moment.area, 48.3, 0.01);
  EXPECT_NEAR(moment.y / moment.area, 51.6, 0.01);
  for (const Vec2 p : curves[0]) EXPECT_NEAR(norm(p - Vec2{48.3f, 51.6f}), 30, 0.1);
}

TEST(Contour, HoleTurnsTheOtherWay) {
  Grid<float> value = disc(100, {50, 50}, 40);
  const Grid<float> hole = disc(100, {50, 50}, 20);
  for (std::size_t i = 0; i < value.data().size(); ++i) value.data()[i] -= hole.data()[i];
  const auto curves = contours(value, 0.5f);
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_NEAR(signed_area(curves[0]), std::numbers::pi * 1600, 3);
  EXPECT_NEAR(signed_area(curves[1]), -std::numbers::pi * 400, 3);
}

TEST(Contour, ClosesAtTheGridsEdge) {
  const auto curves = contours(Grid<float>(4, 3, 1.f), 0.5f);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_NEAR(signed_area(curves[0]), 4 * 3 - 4 * 0.125, 1e-4);  // half a node around, without the corners
}

TEST(Contour, MeanOfASaddleDecides) {
  Grid<float> value(2, 2, 0.f);
  value(0, 0) = value(1, 1) = 1;
  value(0, 1) = value(1, 0) = 0.1f;
  EXPECT_EQ(contours(value, 0.5f).size(), 1u);
  value(0, 0) = value(1, 1) = 0.6f;
  EXPECT_EQ(contours(value, 0.5f).size(), 2u);
}

TEST(Contour, NothingAboveTheLevel) { EXPECT_TRUE(contours(Grid<float>(5, 5, 0.4f), 0.5f).empty()); }

TEST(Contour, SeparatesTheNodesOfAnyGrid) {
  EXPECT_TRUE(rc::check([] {
    const Grid<float> value = any_grid();
    const auto curves = contours(value, 0.5f);
    for (int y = 0; y < value.height(); ++y) {
      for (int x = 0; x < value.width(); ++x) {
        RC_ASSERT(is_inside(curves, {float(x), float(y)}) == (value(x, y) >= 0.5f));
      }
    }
  }));
}

TEST(Contour, StepsStayWithinACellOfAnyGrid) {
  EXPECT_TRUE(rc::check([] {
    for (const auto& curve : contours(any_grid(), 0.5f)) {
      RC_ASSERT(curve.size() >= 4u);
      for (std::size_t i = 0; i < curve.size(); ++i) {
        const float step = norm(curve[(i + 1) % curve.size()] - curve[i]);
        RC_ASSERT(step > 0);
        RC_ASSERT(step < 1.4143f);
      }
    }
  }));
}

}  // namespace test_contour
}  // namespace tessera
