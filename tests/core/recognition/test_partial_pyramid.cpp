// Pyramids along an open arc equal those of the closed curve that it was cut from, as far as the arc goes.
#include "core/recognition/partial_pyramid.h"

#include <gtest/gtest.h>

#include "core/geometry/closed_curve.h"
#include "core/shape/level_curve.h"
#include "support/synthetic_library.h"

namespace tessera {
namespace test_partial_pyramid {

constexpr PadParameters kPad;
constexpr float kSigma = 0.03f;
constexpr int kPoints = 400;

Curve smooth_outline(const Shape& shape) {
  const std::vector<Vec2> even = resampled_closed(shape.outline.curves.front(), kPoints);
  return {resampled_closed(gaussian_smoothed(even, kSigma), kPoints), true};
}

TEST(PartialPyramid, OfAClosedCurveIsTheShapesOwn) {
  for (const Shape& shape : test::synthetic_library(6)) {
    const Curve curve = smooth_outline(shape);
    const std::vector<PartialPyramid> partial = partial_pyramids(curve, kSigma, 4, kPad);
    const std::vector<ArclengthPyramid> whole = sample_pyramids(curve.points, kSigma, kPoints / 4, kPad);
    ASSERT_EQ(partial.size(), whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i) {
      ASSERT_EQ(partial[i].left_levels, kPad.levels);
      ASSERT_EQ(partial[i].right_levels, kPad.levels);
      EXPECT_EQ(partial[i].pyramid.convexity, whole[i].convexity);
      for (int level = 0; level < kPad.levels; ++level) {
        const auto k = std::size_t(level);
        EXPECT_NEAR(partial[i].pyramid.left[k], whole[i].left[k], 1e-3 + 1e-3 * whole[i].left[k]);
        EXPECT_NEAR(partial[i].pyramid.right[k], whole[i].right[k], 1e-3 + 1e-3 * whole[i].right[k]);
      }
    }
  }
}

TEST(PartialPyramid, OfAnArcIsTheWholesWhereTheArcReaches) {
  int levels_seen = 0;
  for (const Shape& shape : test::synthetic_library(6)) {
    const Curve whole = smooth_outline(shape);
    const Curve arc{{whole.points.begin() + 50, whole.points.begin() + 250}, false};
    const auto of_arc = partial_pyramids(arc, kSigma, 1, kPad);
    const auto of_whole = partial_pyramids(whole, kSigma, 1, kPad);
    for (std::size_t i = 2; i + 2 < of_arc.size(); ++i) {  // the two ends lack the turning at their own vertex
      const ArclengthPyramid& expected = of_whole[50 + i].pyramid;
      for (int level = 0; level < of_arc[i].left_levels; ++level, ++levels_seen) {
        const auto k = std::size_t(level);
        EXPECT_NEAR(of_arc[i].pyramid.left[k], expected.left[k], 1e-4);
        const Vec2 off = of_arc[i].pyramid.keypoint[std::size_t(kPad.levels - 1 - level)] -
                         expected.keypoint[std::size_t(kPad.levels - 1 - level)];
        EXPECT_NEAR(norm(off), 0, 1e-3);
      }
      for (int level = 0; level < of_arc[i].right_levels; ++level, ++levels_seen) {
        EXPECT_NEAR(of_arc[i].pyramid.right[std::size_t(level)], expected.right[std::size_t(level)], 1e-4);
      }
      // A missing level lies beyond the arc's end, or so near to it that smoothing has changed it.
      if (of_arc[i].right_levels < kPad.levels) {
        const float left_of_arc = float(of_arc.size() - 1 - i) * length_of(arc) / float(arc.points.size() - 1);
        EXPECT_GT(expected.right[std::size_t(of_arc[i].right_levels)], left_of_arc - kSigma - 0.01f);
      }
    }
  }
  EXPECT_GT(levels_seen, 1000);
}

TEST(PartialPyramid, OfAStraightLineHasNoLevels) {
  const Curve line = resampled({{{0, 0}, {10, 0}}, false}, 100);
  for (const PartialPyramid& p : partial_pyramids(line, 0.3f, 1, kPad)) {
    EXPECT_EQ(p.left_levels, 0);
    EXPECT_EQ(p.right_levels, 0);
    EXPECT_FALSE(has_enough_levels(p));
  }
}

TEST(PartialPyramid, TellsEnoughWithFourLevelsOnBothSides) {
  EXPECT_TRUE(has_enough_levels({{}, 2, 2}));
  EXPECT_FALSE(has_enough_levels({{}, 1, 5}));
  EXPECT_FALSE(has_enough_levels({{}, 3, 1}));
}

}  // namespace test_partial_pyramid
}  // namespace tessera
