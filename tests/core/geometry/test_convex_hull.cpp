#include "core/geometry/convex_hull.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

namespace tessera {
namespace test_convex_hull {

std::vector<Vec2> any_points(int most) {
  std::vector<Vec2> points(std::size_t(*rc::gen::inRange(1, most)));
  for (Vec2& p : points) p = {float(*rc::gen::inRange(-9, 10)), float(*rc::gen::inRange(-9, 10))};
  return points;
}

double side_of(Vec2 a, Vec2 b, Vec2 p) {
  return (double(b.x) - a.x) * (double(p.y) - a.y) - (double(b.y) - a.y) * (double(p.x) - a.x);
}

TEST(ConvexHull, HasAllPointsOnTheLeftOfEachSideAndTurnsLeft) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<Vec2> points = any_points(40);
    const std::vector<Vec2> hull = convex_hull(points);
    RC_ASSERT(!hull.empty());
    RC_PRE(hull.size() > 2);
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const Vec2 next = hull[(i + 1) % hull.size()];
      RC_ASSERT(side_of(hull[i], next, hull[(i + 2) % hull.size()]) > 0);
      for (const Vec2 p : points) RC_ASSERT(side_of(hull[i], next, p) >= 0);
    }
  }));
}

TEST(ConvexHull, OfPointsOnALineAreItsEnds) {
  EXPECT_EQ(convex_hull({{1, 1}, {3, 3}, {2, 2}, {3, 3}}), (std::vector<Vec2>{{1, 1}, {3, 3}}));
  EXPECT_EQ(convex_hull({{1, 1}, {1, 1}}), (std::vector<Vec2>{{1, 1}}));
  EXPECT_EQ(least_width(convex_hull({{1, 1}, {3, 3}, {2, 2}})), 0);
}

TEST(ConvexHull, LeastWidthIsThatOfTheNarrowestStrip) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<Vec2> hull = convex_hull(any_points(20));
    RC_PRE(hull.size() > 2);
    const double width = least_width(hull);
    double narrowest = 1e9;
    for (int i = 0; i < 1800; ++i) {  // a strip every tenth of a degree
      const double x = std::cos(i * 0.1 * 3.14159265358979 / 180), y = std::sin(i * 0.1 * 3.14159265358979 / 180);
      double low = 1e9, high = -1e9;
      for (const Vec2 p : hull) {
        low = std::min(low, p.x * x + p.y * y);
        high = std::max(high, p.x * x + p.y * y);
      }
      RC_ASSERT(high - low >= width - 1e-6);
      narrowest = std::min(narrowest, high - low);
    }
    RC_ASSERT(narrowest - width < 0.05);  // the hull is 20 wide, and the angle errs by up to 0.05 degrees
  }));
}

}  // namespace test_convex_hull
}  // namespace tessera
