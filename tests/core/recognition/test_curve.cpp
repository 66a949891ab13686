// Curves: invalid ones, even points, and smoothing that keeps the ends of open curves.
#include "core/recognition/curve.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace tessera {
namespace test_curve {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(Curve, SaysWhyPointsAreNone) {
  EXPECT_EQ(curve_fault({{}, false}), "it has 0 points; an open curve has at least 2");
  EXPECT_EQ(curve_fault({{{1, 1}}, false}), "it has 1 point; an open curve has at least 2");
  EXPECT_EQ(curve_fault({{{1, 1}, {2, 1}}, true}), "it has 2 points; a closed curve has at least 3");
  EXPECT_EQ(curve_fault({{{1, 1}, {kNan, 1}}, false}), "point 1 is not a number, or lies beyond +-1e6");
  EXPECT_EQ(curve_fault({{{2e6f, 1}, {1, 1}}, false}), "point 0 is not a number, or lies beyond +-1e6");
  EXPECT_EQ(curve_fault({{{1, 1}, {1, 1}, {1, 1}}, true}), "all its points are one");
  EXPECT_EQ(curve_fault({std::vector<Vec2>(kMostCurvePoints + 1), false}),
            "it has 4194305 points; at most 4194304 are allowed");
  EXPECT_EQ(curve_fault({{{0, 0}, {1, 0}}, false}), "");
}

TEST(Curve, LengthCountsTheClosingEdge) {
  const std::vector<Vec2> corner = {{0, 0}, {3, 0}, {3, 4}};
  EXPECT_FLOAT_EQ(length_of({corner, false}), 7);
  EXPECT_FLOAT_EQ(length_of({corner, true}), 12);
}

TEST(Curve, ResamplingKeepsTheEndsOfAnOpenCurve) {
  const Curve even = resampled({{{0, 0}, {3, 0}, {3, 4}}, false}, 8);
  ASSERT_EQ(even.points.size(), 8u);
  EXPECT_EQ(even.points.front(), (Vec2{0, 0}));
  EXPECT_EQ(even.points.back(), (Vec2{3, 4}));
  EXPECT_EQ(even.points[3], (Vec2{3, 0}));
  EXPECT_FALSE(even.closed);
}

TEST(Curve, SmoothingKeepsStraightLinesAndEnds) {
  Curve line{{}, false};
  for (int i = 0; i < 50; ++i) line.points.push_back({float(i), 2 * float(i)});
  const Curve smooth = smoothed(line, 6);
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    EXPECT_NEAR(smooth.points[i].x, line.points[i].x, 1e-3);
    EXPECT_NEAR(smooth.points[i].y, line.points[i].y, 1e-3);
  }
}

TEST(Curve, SmoothingTakesOutWhatIsNarrow) {
  Curve zigzag{{}, false};
  for (int i = 0; i < 200; ++i) zigzag.points.push_back({float(i), i % 2 ? 0.5f : -0.5f});
  const Curve smooth = smoothed(zigzag, 4);
  for (std::size_t i = 20; i < 180; ++i) EXPECT_NEAR(smooth.points[i].y, 0, 0.01);
}

TEST(Curve, TangentsAreThoseOfACircle) {
  Curve circle{{}, true};
  for (int i = 0; i < 64; ++i) {
    const float angle = 2 * std::numbers::pi_v<float> * float(i) / 64;
    circle.points.push_back({std::cos(angle), std::sin(angle)});
  }
  const std::vector<Vec2> tangents = tangents_of(circle);
  for (std::size_t i = 0; i < 64; ++i) {
    EXPECT_NEAR(tangents[i].x, -circle.points[i].y, 1e-5);
    EXPECT_NEAR(tangents[i].y, circle.points[i].x, 1e-5);
  }
}

RC_GTEST_PROP(Curve, resampled_points_are_evenly_apart, ()) {
  const bool closed = *rc::gen::arbitrary<bool>();
  const auto count = *rc::gen::inRange<std::size_t>(3, 40);
  Curve curve{{}, closed};
  for (std::size_t i = 0; i < count; ++i) {
    curve.points.push_back({float(*rc::gen::inRange(-100, 100)), float(*rc::gen::inRange(-100, 100))});
  }
  RC_PRE(curve_fault(curve).empty());
  const int points = *rc::gen::inRange(2, 300);
  const Curve even = resampled(curve, points);
  RC_ASSERT(even.points.size() == std::size_t(points));
  const float step = length_of(curve) / float(closed ? points : points - 1);
  for (std::size_t i = 0; i + 1 < even.points.size(); ++i) {
    RC_ASSERT(norm(even.points[i + 1] - even.points[i]) <= step * 1.001f + 1e-3f);
  }
}

}  // namespace test_curve
}  // namespace tessera
