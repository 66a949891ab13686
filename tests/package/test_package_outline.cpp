// Outlines of the public library: valid ones, their direction, their measures, and refused ones.
#include <gtest/gtest.h>

#include <limits>

#include "sample_outlines.h"

namespace tessera {
namespace test_package_outline {

using matching::Curve;
using matching::Outline;
using matching::Point;
using test::error_of;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<Point> square(double low, double high) { return {{low, low}, {high, low}, {high, high}, {low, high}}; }

std::string fault_of(std::vector<Point> points, bool closed = true, double smoothing = 0) {
  const Outline outline{{{std::move(points), closed}}, smoothing};
  return error_of([&] { check(outline); });
}

TEST(PackageOutline, PolygonsAreTurnedSoThatTheInteriorIsOnTheLeft) {
  std::vector<Point> clockwise = square(0, 10);
  std::reverse(clockwise.begin(), clockwise.end());
  // A frame with an island in its hole, whatever the direction of its polygons.
  for (const std::vector<Point>& outer : {square(0, 10), clockwise}) {
    const Outline frame = matching::make_outline({square(2, 8), outer, square(4, 6)});
    EXPECT_DOUBLE_EQ(area_of(frame), 100 - 36 + 4);
    EXPECT_DOUBLE_EQ(length_of(frame), 40 + 24 + 8);
  }
}

TEST(PackageOutline, AreaHoldsFarFromTheOrigin) {
  const Outline far = test::mapped(matching::make_outline({square(0, 1)}), {1, 0, 5e8, -3e9});
  EXPECT_NEAR(area_of(far), 1, 1e-6);
}

TEST(PackageOutline, OpenCurvesHaveLengthAndNoArea) {
  const Outline lines{{{{{0, 0}, {3, 4}}, false}, {{{0, 0}, {0, 1}, {0, 2}}, false}}};
  EXPECT_DOUBLE_EQ(length_of(lines), 7);
  EXPECT_DOUBLE_EQ(area_of(lines), 0);
}

TEST(PackageOutline, WhatIsNoCurveIsNamed) {
  EXPECT_EQ(error_of([] { check(Outline{}); }), "an outline without curves; allowed: 1 or more");
  EXPECT_EQ(fault_of({}), "curve 0: found 0 points, allowed: 3 points or more of a closed curve");
  EXPECT_EQ(fault_of({{1, 2}}), "curve 0: found 1 point, allowed: 3 points or more of a closed curve");
  EXPECT_EQ(fault_of({{1, 2}}, false), "curve 0: found 1 point, allowed: 2 points or more of an open curve");
  EXPECT_EQ(fault_of({{0, 0}, {kNan, 1}, {1, 1}}),
            "curve 0: point 1: found the coordinate nan, allowed: -1e15 to 1e15");
  EXPECT_EQ(fault_of({{0, 0}, {1, 0}, {1, -kInfinity}}),
            "curve 0: point 2: found the coordinate -inf, allowed: -1e15 to 1e15");
  EXPECT_EQ(fault_of({{0, 0}, {1, 0}, {1, 1e300}}),
            "curve 0: point 2: found the coordinate 1e+300, allowed: -1e15 to 1e15");
  EXPECT_NE(fault_of({{7, 7}, {7, 7}, {7, 7}}).find("points are all equal"), std::string::npos);
  EXPECT_NE(fault_of({{1e15, 1e15}, {1e15 - 1, 1e15}, {1e15, 1e15 - 1}}).find("too close together"), std::string::npos);
  Outline speck{{{square(0, 1), true}, {square(0, 1e-9), true}}};
  EXPECT_EQ(error_of([&] { check(speck); }).substr(0, 8), "curve 1:");
}

TEST(PackageOutline, SmoothingHasLimits) {
  EXPECT_EQ(fault_of(square(0, 1), true, 0.1), "");
  for (const double smoothing : {-0.1, 0.2, kNan, kInfinity}) {
    EXPECT_EQ(fault_of(square(0, 1), true, smoothing).substr(0, 10), "smoothing:") << smoothing;
  }
}

TEST(PackageOutline, HugeOutlinesAreRefusedBeforeAnythingIsComputed) {
  const std::vector<Curve> many(matching::kMostCurves + 1, Curve{square(0, 1), true});
  EXPECT_NE(error_of([&] { check(Outline{many}); }).find("1001 curves"), std::string::npos);
  const std::vector<Point> points(matching::kMostPoints + 1);
  EXPECT_NE(error_of([&] { check(Outline{{{points, true}}}); }).find("4194305 points"), std::string::npos);
}

TEST(PackageSimilarity, ProductsAndInverses) {
  const matching::Similarity f = test::similarity(2, 0.7, 3, -4);
  const matching::Similarity g = test::similarity(0.3, -2, 1, 8);
  const Point p{5, 6};
  const Point once = f.apply(g.apply(p));
  EXPECT_NEAR((f * g).apply(p).x, once.x, 1e-12);
  EXPECT_NEAR((f * g).apply(p).y, once.y, 1e-12);
  EXPECT_NEAR(f.inverse().apply(f.apply(p)).x, p.x, 1e-12);
  EXPECT_NEAR(f.scale(), 2, 1e-12);
  EXPECT_NEAR(f.rotation_rad(), 0.7, 1e-12);
}

}  // namespace test_package_outline
}  // namespace tessera
