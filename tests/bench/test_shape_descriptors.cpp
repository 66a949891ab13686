// The descriptors that PAD is compared with: values known by hand, and their invariances.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/descriptors/boundary_points.h"
#include "bench/descriptors/shape_descriptor.h"
#include "core/geometry/similarity.h"

namespace tessera::bench {
namespace test_shape_descriptors {

constexpr double kPi = std::numbers::pi;

/// A curve of radius 1 + sum of amplitude[k] cos(k angle + k k), with its interior on the left.
Curve lobes(const std::vector<double>& amplitude, int count = 720) {
  Curve curve{{}, true};
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * kPi * i / count;
    double radius = 1;
    for (std::size_t k = 0; k < amplitude.size(); ++k) {
      radius += amplitude[k] * std::cos(double(k) * angle + double(k * k));
    }
    curve.points.push_back({float(radius * std::cos(angle)), float(radius * std::sin(angle))});
  }
  return curve;
}

Curve ellipse(float ratio) {
  Curve curve = lobes({});
  for (Vec2& p : curve.points) p.x *= ratio;
  return curve;
}

Curve rectangle(float width, float height) { return {{{0, 0}, {width, 0}, {width, height}, {0, height}}, true}; }

Curve mirrored(Curve curve) {
  for (Vec2& p : curve.points) p.x = -p.x;
  std::reverse(curve.points.begin(), curve.points.end());
  return curve;
}

TEST(HuMoments, OfARectangleAreKnown) {
  // The normalised moments of a rectangle a x b are a / 12 b and b / 12 a; all of third order are 0.
  const Description d = make_hu_moments()->describe({rectangle(200, 100)}, 0);
  ASSERT_EQ(d.size(), 7u);
  EXPECT_NEAR(d[0], (2 + 0.5) / 12, 1e-5);
  EXPECT_NEAR(d[1], (2 - 0.5) / 12, 1e-5);
  for (std::size_t k = 2; k < 7; ++k) EXPECT_NEAR(d[k], 0, 2e-3) << k;
}

TEST(HuMoments, OfACircleAndOfARing) {
  const Curve circle = lobes({});
  EXPECT_NEAR(make_hu_moments()->describe({circle}, 0)[0], 1 / (2 * kPi), 1e-4);
  // The value for a hole of half the radius: (1 - 1/16) / 2 pi (1 - 1/4)^2.
  Curve hole = circle;
  for (Vec2& p : hole.points) p = p * 0.5f;
  std::reverse(hole.points.begin(), hole.points.end());
  EXPECT_NEAR(make_hu_moments()->describe({circle, hole}, 0)[0], (15. / 16) / (2 * kPi * 9 / 16), 1e-4);
}

TEST(HuMoments, OfNoAreaAreNone) {
  EXPECT_EQ(make_hu_moments()->describe({{{{0, 0}, {1, 0}}, false}}, 0), Description(7, 0.f));
}

TEST(IntegralInvariants, OfACircleAreLenses) {
  const Description d = make_integral_invariants()->describe({lobes({})}, 0);
  const double radii[] = {0.08, 0.16, 0.32, 0.64};
  for (std::size_t i = 0; i < d.size(); ++i) {
    const double r = radii[i % 4] * std::sqrt(kPi);
    const double lens = r * r * std::acos(r / 2) + std::acos(1 - r * r / 2) - r / 2 * std::sqrt(4 - r * r);
    EXPECT_NEAR(d[i], lens / (kPi * r * r), 4e-3) << "radius " << r;
  }
}

TEST(IntegralInvariants, AreAHalfOnStraightLinesAndAQuarterInCorners) {
  const Description d = make_integral_invariants()->describe({rectangle(1, 1)}, 0);
  float least = 1, most = 0;
  for (std::size_t i = 0; i < d.size(); i += 4) {
    least = std::min(least, d[i]);
    most = std::max(most, d[i]);
  }
  EXPECT_NEAR(most, 0.5, 0.01);
  EXPECT_GT(least, 0.24);
  EXPECT_LT(least, 0.42);
}

TEST(IntegralInvariants, ACommonUnitKeepsTheSize) {
  const auto invariants = make_integral_invariants();
  const Curve small = lobes({0, 0, 0.1, 0.2});
  Curve large = small;
  for (Vec2& p : large.points) p = p * 2;
  EXPECT_LT(invariants->distance(invariants->describe({small}, 0), invariants->describe({large}, 0)), 1e-3);
  EXPECT_GT(invariants->distance(invariants->describe({small}, 1), invariants->describe({large}, 1)), 0.01);
}

TEST(CurvatureScaleSpace, OfConvexCurvesHasNoMaxima) {
  const auto scale_space = make_curvature_scale_space();
  EXPECT_TRUE(scale_space->describe({lobes({})}, 0).empty());
  EXPECT_TRUE(scale_space->describe({ellipse(3)}, 0).empty());
  EXPECT_TRUE(scale_space->describe({rectangle(3, 2)}, 0).empty());
}

TEST(CurvatureScaleSpace, HasOneMaximumForEachConcavity) {
  const Description d = make_curvature_scale_space()->describe({lobes({0, 0, 0, 0.3})}, 0);
  ASSERT_EQ(d.size(), 6u) << "three places and heights";
  std::vector<float> places = {d[0], d[2], d[4]};
  std::sort(places.begin(), places.end());
  EXPECT_NEAR(places[1] - places[0], 1. / 3, 0.01);
  EXPECT_NEAR(places[2] - places[1], 1. / 3, 0.01);
  EXPECT_NEAR(d[1], d[5], 0.1 * double(d[1])) << "of one height";
  const Description deeper = make_curvature_scale_space()->describe({lobes({0, 0, 0, 0.5})}, 0);
  EXPECT_GT(deeper[1], 1.1f * d[1]);
}

TEST(CurvatureScaleSpace, MaximaWithoutPartnersCostTheirHeights) {
  const auto scale_space = make_curvature_scale_space();
  EXPECT_NEAR(scale_space->distance({}, {0.2f, 0.1f, 0.5f, 0.05f}), 0.15, 1e-6);
  EXPECT_NEAR(scale_space->distance({0.9f, 0.1f}, {0.2f, 0.1f, 0.5f, 0.05f}), 0.05, 1e-6) << "moved along by 0.3";
}

TEST(TriangleAreas, OfACircleAreTheLargestEverywhere) {
  for (const float area : make_triangle_areas()->describe({lobes({})}, 0)) EXPECT_NEAR(area, 1, 0.02);
}

TEST(TriangleAreas, AreNegativeWhereTheBoundaryIsConcave) {
  const Description d = make_triangle_areas()->describe({lobes({0, 0, 0, 0.4})}, 0);
  // The sign of the smallest triangles changes six times along three lobes.
  const std::size_t sizes = d.size() / 128;
  int changes = 0;
  for (std::size_t i = 0; i < 128; ++i) changes += d[i * sizes] * d[(i + 1) % 128 * sizes] < 0;
  EXPECT_EQ(changes, 6);
}

TEST(ShapeContext, OfACircleIsOneHistogramToTheLeft) {
  const Description d = make_shape_context()->describe({lobes({})}, 0);
  ASSERT_EQ(d.size(), 100u * 60);
  for (std::size_t i = 0; i < 100; ++i) {
    float left = 0;
    for (std::size_t ring = 0; ring < 5; ++ring) {
      for (std::size_t k = 0; k < 6; ++k) left += d[i * 60 + ring * 12 + k];
    }
    EXPECT_NEAR(left, 1, 1e-4) << "the interior is on the left of every tangent, and nothing is beyond the rings";
  }
  // The point at the other end of the diameter is 2 R away, or pi / 2 mean distances: in the fifth ring, straight left.
  EXPECT_GT(d[4 * 12 + 2] + d[4 * 12 + 3], 0.1);
}

TEST(ShapeContext, CountsNothingForAHiddenPart) {
  const auto context = make_shape_context();
  const Curve whole = lobes({0, 0, 0.2, 0.2, 0.1});
  Curve half{{whole.points.begin() + 100, whole.points.begin() + 400}, false};
  const Curve other = lobes({0, 0, 0, 0, 0.3});
  const auto describe = [&](const Curve& c) { return context->describe({c}, 1); };
  EXPECT_LT(context->distance(describe(half), describe(whole)), context->distance(describe(half), describe(other)));
}

TEST(WarpedDifference, FindsPartsAnywhereOnAClosedCurve) {
  const std::vector<float> known = {1, 5, 2, 8, 3, 9};
  EXPECT_EQ(warped_difference(known, known, 1), 0);
  EXPECT_EQ(warped_difference({3, 9, 1, 5}, known, 1), 0) << "past the place where the rows begin";
  EXPECT_EQ(warped_difference({2, 8, 8, 3}, known, 1), 0) << "stretched";
  EXPECT_EQ(warped_difference({9, 3}, {9, 0, 0, 0, 3, 3}, 2), 1.5) << "rows of two: (9, 3) is nearest to (9, 0)";
  EXPECT_EQ(warped_difference({4}, known, 1), 1);
}

TEST(EvenPoints, AreSharedOutByLength) {
  const Curve line{{{0, 0}, {30, 0}}, false}, longer{{{0, 5}, {90, 5}}, false};
  const EvenPoints points = even_points({line, longer}, 40);
  ASSERT_EQ(points.position.size(), 40u);
  EXPECT_EQ(std::count_if(points.position.begin(), points.position.end(), [](Vec2 p) { return p.y < 2; }), 10);
  EXPECT_NEAR(points.tangent[20].x, 1, 1e-5);
}

TEST(ClosedBoundary, JoinsArcsWhereTheyAreMost) {
  const Curve arc{{{0, 0}, {10, 0}}, false}, other{{{10, 5}, {0, 5}}, false};
  EXPECT_EQ(closed_boundary({arc, other}).points.size(), 4u);
  EXPECT_EQ(closed_boundary({arc, rectangle(30, 30)}), rectangle(30, 30));
}

/// A turn, another size, another place or another first point changes nothing. The mirror image and another shape are farther away than any
/// of these.
/// The heights of the maxima of the curvature scale space, the highest first: every second number of the description.
std::vector<float> heights_of(const Description& maxima) {
  std::vector<float> heights;
  for (std::size_t i = 1; i < maxima.size(); i += 2) heights.push_back(maxima[i]);
  return heights;
}

void expect_same_high_maxima(const Description& a, const Description& b) {
  const std::vector<float> of_a = heights_of(a), of_b = heights_of(b);
  for (std::size_t i = 0; i < of_a.size() && of_a[i] > 0.4f * of_a[0]; ++i) {
    RC_ASSERT(i < of_b.size());
    RC_ASSERT(std::abs(of_a[i] - of_b[i]) < 0.1f * of_a[0]);
  }
}

RC_GTEST_PROP(ShapeDescriptors, are_invariant_to_pose, ()) {
  const auto draw = [] {
    std::vector<double> amplitude = {0, 0};
    for (int k = 2; k < 7; ++k) amplitude.push_back(0.01 * *rc::gen::inRange(-18, 19));
    amplitude[3] = 0.2;
    return amplitude;
  };
  const Curve shape = lobes(draw());
  const double angle = 0.001 * *rc::gen::inRange(0, 6283), scale = 0.1 * *rc::gen::inRange(2, 100);
  const Similarity pose{float(scale * std::cos(angle)), float(scale * std::sin(angle)), 40, -7};
  Curve moved = shape;
  for (Vec2& p : moved.points) p = pose.apply(p);
  std::rotate(moved.points.begin(), moved.points.begin() + *rc::gen::inRange(0, 720), moved.points.end());
  const Curve other = ellipse(2);
  for (const auto& descriptor : all_descriptors()) {
    const Description d = descriptor->describe({shape}, 0);
    RC_ASSERT(descriptor->distance(d, d) < 1e-6f);
    const float to_moved = descriptor->distance(d, descriptor->describe({moved}, 0));
    const float to_other = descriptor->distance(d, descriptor->describe({other}, 0));
    RC_LOG(descriptor->name() + ": " + std::to_string(to_moved) + ", other " + std::to_string(to_other));
    if (descriptor->name() == "curvature-scale-space") {
      // The distance jumps where a maximum is about as low as the threshold. The higher maxima stay.
      expect_same_high_maxima(d, descriptor->describe({moved}, 0));
    } else {
      RC_ASSERT(to_moved < 0.35f * to_other);
    }
  }
}

TEST(ShapeDescriptors, TellMirrorImages) {
  const Curve shape = lobes({0, 0, 0.25, 0.2, 0.1, 0.08});
  for (const auto& descriptor : all_descriptors()) {
    const Description d = descriptor->describe({shape}, 0);
    EXPECT_GT(descriptor->distance(d, descriptor->describe({mirrored(shape)}, 0)), 1e-3f) << descriptor->name();
  }
}

}  // namespace test_shape_descriptors
}  // namespace tessera::bench
