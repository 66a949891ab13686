// The spline removes detail finer than its width and keeps the rest.
#include "core/geometry/smoothing_spline.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <numbers>

#include "core/geometry/closed_curve.h"
#include "core/geometry/polygon.h"
#include "support/random_curves.h"

namespace tessera {
namespace test_smoothing_spline {

constexpr double kPi = std::numbers::pi;

std::vector<Vec2> circle(double radius, int points, double ripple = 0, int waves = 0) {
  std::vector<Vec2> curve;
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * kPi * i / points;
    const double r = radius + ripple * std::cos(waves * angle);
    curve.push_back({float(r * std::cos(angle)), float(r * std::sin(angle))});
  }
  return curve;
}

/// The largest distance of the curve from a circle around the origin.
double deviation(const std::vector<Vec2>& curve, double radius) {
  double most = 0;
  for (const Vec2 p : curve) most = std::max(most, std::abs(norm(p) - radius));
  return most;
}

std::vector<Vec2> scaled_random_curve(float scale) {
  std::vector<Vec2> curve = test::random_curve(*rc::gen::inRange<std::uint32_t>(1, 1u << 30), 1500);
  for (Vec2& p : curve) p = p * scale;
  return curve;
}

TEST(SmoothingSpline, CircleStaysACircle) {
  const ClosedSpline spline = smoothing_spline(circle(100, 700), 1);
  EXPECT_NEAR(spline.length(), 2 * kPi * 100, 0.05);
  const std::vector<Vec2> points = spline.even_points(512);
  EXPECT_LT(deviation(points, 100), 0.01);
  EXPECT_NEAR(signed_area(points), kPi * 1e4, 2);
  for (double t = 0; t < spline.spans(); t += 7.3) EXPECT_NEAR(spline.curvature(t), 0.01, 5e-4);
}

TEST(SmoothingSpline, RippleIsDampedAsByAGaussian) {
  const double radius = 100, ripple = 0.5;
  for (const double sigma : {1.0, 2.0, 4.0}) {
    // The wave number at which a Gaussian of this width halves the ripple.
    const int waves = int(std::lround(radius * std::sqrt(2 * std::log(2.0)) / sigma));
    const auto kept = smoothing_spline(circle(radius, 6000, ripple, waves), sigma).even_points(2048);
    EXPECT_NEAR(deviation(kept, radius), ripple / 2, 0.06) << "sigma " << sigma;
    const auto coarse = smoothing_spline(circle(radius, 6000, ripple, waves / 3), sigma).even_points(2048);
    EXPECT_GT(deviation(coarse, radius), 0.95 * ripple) << "sigma " << sigma;
    const auto fine = smoothing_spline(circle(radius, 6000, ripple, waves * 3 / 2), sigma).even_points(2048);
    EXPECT_LT(deviation(fine, radius), 0.3 * ripple) << "sigma " << sigma;
  }
}

TEST(SmoothingSpline, EvenPointsAreEven) {
  EXPECT_TRUE(rc::check([] {
    const auto points = smoothing_spline(scaled_random_curve(100), 1).even_points(1024);
    const float mean = closed_length(points) / 1024;
    for (int i = 0; i < 1024; ++i) {
      RC_ASSERT(std::abs(norm(points[(i + 1) % 1024] - points[i]) - mean) < 0.02f * mean);
    }
  }));
}

TEST(SmoothingSpline, StaysNearASmoothCurve) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<Vec2> curve = scaled_random_curve(100);
    const std::vector<Vec2> points = smoothing_spline(curve, 1).even_points(1500);
    RC_ASSERT(std::abs(signed_area(points) / signed_area(curve) - 1) < 1e-3);
    for (int i = 0; i < 1500; i += 10) RC_ASSERT(norm(points[i] - curve[i]) < 1.f);
  }));
}

TEST(SmoothingSpline, DerivativesAreThoseOfThePosition) {
  EXPECT_TRUE(rc::check([] {
    const ClosedSpline spline = smoothing_spline(scaled_random_curve(100), 2);
    const double t = double(*rc::gen::inRange(0, 1 << 20)) / (1 << 20) * spline.spans();
    const double h = 0.05;
    const Vec2 first = (spline.position(t + h) - spline.position(t - h)) * float(1 / (2 * h));
    const Vec2 second = (spline.first_derivative(t + h) - spline.first_derivative(t - h)) * float(1 / (2 * h));
    RC_ASSERT(norm(first - spline.first_derivative(t)) < 0.01f);
    RC_ASSERT(norm(second - spline.second_derivative(t)) < 0.01f);
  }));
}

TEST(SmoothingSpline, GoesRoundAndRound) {
  const ClosedSpline spline = smoothing_spline(circle(10, 60), 1);
  EXPECT_EQ(spline.position(0), spline.position(spline.spans()));
  EXPECT_EQ(spline.position(spline.spans() - 0.5), spline.position(-0.5));
}

TEST(SmoothingSpline, TinyPolygon) {
  const ClosedSpline spline = smoothing_spline({{0, 0}, {1, 0}, {0, 1}}, 1);
  EXPECT_GT(spline.length(), 0);
  EXPECT_EQ(spline.even_points(16).size(), 16u);
}

}  // namespace test_smoothing_spline
}  // namespace tessera
