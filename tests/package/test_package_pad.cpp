// PADs of the public library: known values, invariance, missing levels, limits of the settings.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "sample_outlines.h"

namespace tessera {
namespace test_package_pad {

using matching::Outline;
using matching::Pad;
using matching::pads_of;
using matching::PadSettings;
using test::error_of;

/// The turning beyond noise: of the curvature 1 / 50, 0.024 / smoothing counts as noise.
constexpr double kTurningOfCircle = 1.0 / 50 - 0.024 / 5;  // rad per unit of length

TEST(PackagePad, LevelsOfACircle) {
  const std::vector<Pad> pads = pads_of(test::circle(50), {.smoothing = 5, .samples = 12});
  ASSERT_EQ(pads.size(), 12u);
  for (std::size_t k = 0; k < pads.size(); ++k) {
    EXPECT_NEAR(pads[k].along, 2 * M_PI * 50 * double(k) / 12, 0.01);
    EXPECT_NEAR(std::hypot(pads[k].position.x, pads[k].position.y), 50, 0.5);
    EXPECT_EQ(pads[k].convexity, 1);
    ASSERT_EQ(pads[k].left.size(), 5u);
    ASSERT_EQ(pads[k].right.size(), 5u);
    for (std::size_t level = 0; level < 5; ++level) {
      const double expected = 0.2 * double(1 << level) / kTurningOfCircle;
      EXPECT_NEAR(pads[k].left[level], expected, 0.03 * expected);
      EXPECT_NEAR(pads[k].right[level], expected, 0.03 * expected);
    }
    EXPECT_LT(pad_distance(pads[k], pads[0]), 0.02);
  }
}

RC_GTEST_PROP(PackagePad, DoNotDependOnUnitsAndPose, ()) {
  const Outline outline = test::random_outline(*rc::gen::inRange(0u, 1000u));
  const double scale = std::pow(10, *rc::gen::inRange(-9, 9));
  const matching::Similarity map =
      test::similarity(scale, *rc::gen::inRange(0, 628) / 100.0, 3e3 * scale, -7e2 * scale);
  const std::vector<Pad> pads = pads_of(outline);
  const std::vector<Pad> others = pads_of(test::mapped(outline, map));
  RC_ASSERT(pads.size() == others.size());
  for (std::size_t k = 0; k < pads.size(); ++k) {
    // A level ends where the turning reaches a threshold. On a flat stretch, rounding may move that place.
    RC_ASSERT(pads[k].convexity != others[k].convexity || pad_distance(pads[k], others[k]) < 0.05);
    RC_ASSERT(std::abs(others[k].along / scale - pads[k].along) < 1e-3);
  }
}

TEST(PackagePad, OppositeConvexitiesAddUp) {
  Pad convex{.left = {1, 2}, .right = {1, 2}, .convexity = 1};
  Pad concave = convex;
  concave.convexity = -1;
  EXPECT_DOUBLE_EQ(pad_distance(convex, convex), 0);
  EXPECT_DOUBLE_EQ(pad_distance(convex, concave), 1);
  Pad other{.left = {1, 4}, .right = {1, 2}, .convexity = 0};
  EXPECT_DOUBLE_EQ(pad_distance(concave, other), 0.25);
  // Only the two common levels count. Each side is divided by the longer one, and the second element counts half.
  Pad longer{.left = {1, 2, 8}, .right = {1, 2, 8}, .convexity = 1};
  EXPECT_DOUBLE_EQ(pad_distance(convex, longer), 0);
  Pad shorter{.left = {1}, .right = {1, 2}, .convexity = 1};
  EXPECT_EQ(pad_distance(convex, shorter), std::numeric_limits<double>::infinity());
}

TEST(PackagePad, LevelsBeyondTheEndsOfAnOpenCurveAreMissing) {
  Outline arc = test::circle(50);
  arc.curves[0].closed = false;
  arc.curves[0].points.resize(180);
  const std::vector<Pad> pads = pads_of(arc, {.smoothing = 5, .samples = 21});
  ASSERT_EQ(pads.size(), 21u);
  EXPECT_TRUE(pads.front().left.empty());
  EXPECT_TRUE(pads.back().right.empty());
  // Half of the arc turns by 1.1 rad; level 2 needs 0.8, level 3 needs 1.6.
  EXPECT_EQ(pads[10].left.size(), 3u);
  EXPECT_EQ(pads[10].right.size(), 3u);
  EXPECT_NEAR(pads.back().along, length_of(arc), 1e-3);
}

TEST(PackagePad, SettingsHaveLimits) {
  const Outline outline = test::circle(1);
  const auto fault = [&](const PadSettings& settings) { return error_of([&] { pads_of(outline, settings); }); };
  EXPECT_EQ(fault({.levels = 1}), "levels: found 1, allowed: 2 to 6");
  EXPECT_EQ(fault({.levels = 7}), "levels: found 7, allowed: 2 to 6");
  EXPECT_EQ(fault({.delta_tau_rad = 0}), "delta_tau_rad: found 0, allowed: 0.01 to 1");
  EXPECT_EQ(fault({.samples = 0}), "samples: found 0, allowed: 1 to 100000");
  EXPECT_EQ(fault({.smoothing = 3}).substr(0, 28), "smoothing of PADs: found 3, ");
  EXPECT_EQ(fault({.smoothing = std::nan("")}).substr(0, 30), "smoothing of PADs: found nan, ");
}

TEST(PackagePad, AMillionPointsAreMany) {
  EXPECT_EQ(pads_of(test::circle(1e4, 1'000'000)).size(), 64u);
  EXPECT_EQ(pads_of(test::circle(1), {.smoothing = 0.002, .samples = 100000}).size(), 100000u);
}

}  // namespace test_package_pad
}  // namespace tessera
