// The parts in which two curves follow one another: their ends, and their coverage.
#include "core/recognition/matched_runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/synthetic_shapes.h"

namespace tessera {
namespace test_matched_runs {

constexpr RunSettings kRuns{.reach = 3, .least_length = 5};
constexpr RunSettings kAnyDirection{.reach = 3, .least_length = 5, .any_direction = true};

Curve circle() {
  Curve curve{test::polar_curve([](float) { return 100.f; }), true};
  return resampled(curve, 600);
}

Curve line(Vec2 from, Vec2 to) { return resampled({{from, to}, false}, int(norm(to - from))); }

TEST(MatchedRuns, ACircleOnItselfIsOneRunAllRound) {
  const std::vector<MatchedRun> runs = matched_runs({circle()}, {circle()}, {}, kRuns);
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_NEAR(runs[0].of_b.length(), length_of(circle()), 1e-2);
  EXPECT_NEAR(runs[0].of_a.length(), length_of(circle()), 2);
  EXPECT_NEAR(covered_length_of_a({circle()}, runs), length_of(circle()), 2);
}

TEST(MatchedRuns, ARunMayPassTheFirstPointOfAClosedCurve) {
  Curve arc{{}, false};
  for (int i = -90; i <= 90; ++i) {
    const float angle = float(i) / 180 * 3.14159265f;
    arc.points.push_back(Vec2{std::cos(angle), std::sin(angle)} * 100);
  }
  const std::vector<MatchedRun> runs = matched_runs({circle()}, {arc}, {}, kRuns);
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_NEAR(runs[0].of_a.from, 0.75f * length_of(circle()), 1);
  EXPECT_NEAR(runs[0].of_a.to, 1.25f * length_of(circle()), 1);
  EXPECT_NEAR(covered_length_of_a({circle()}, runs), 0.5f * length_of(circle()), 2);
  const std::vector<Vec2> points = points_of(circle(), runs[0].of_a);
  EXPECT_LT(norm(points.front() - Vec2{0, -100}), 2);
  EXPECT_LT(norm(points.back() - Vec2{0, 100}), 2);
  EXPECT_NEAR(length_of({points, false}), runs[0].of_a.length(), 0.5);
}

TEST(MatchedRuns, DirectionsCountWhereBothHaveAnInterior) {
  const Curve a = line({0, 0}, {100, 0});
  const Curve b = line({80, 1}, {20, 1});
  EXPECT_TRUE(matched_runs({a}, {b}, {}, kRuns).empty());
  const std::vector<MatchedRun> runs = matched_runs({a}, {b}, {}, kAnyDirection);
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_TRUE(runs[0].reversed);
  EXPECT_NEAR(runs[0].of_a.from, 20, 1);
  EXPECT_NEAR(runs[0].of_a.to, 80, 1);
  EXPECT_NEAR(runs[0].of_b.length(), 60, 2);
}

TEST(MatchedRuns, ARunEndsWhereTheCurvesPart) {
  const Curve a = line({0, 0}, {100, 0});
  Curve b{{{10, 1}, {50, 1}, {60, 40}, {70, 1}, {90, 1}}, false};
  b = resampled(b, 200);
  const std::vector<MatchedRun> runs = matched_runs({a, line({0, 500}, {9, 500})}, {b}, {}, kRuns);
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_NEAR(runs[0].of_a.to, 50, 2);
  EXPECT_NEAR(runs[1].of_a.from, 70, 2);
  EXPECT_NEAR(covered_length_of_a({a}, runs), 60, 3);
}

TEST(MatchedRuns, TellsWhichCurveOfASetItIs) {
  const std::vector<Curve> a = {line({0, 0}, {100, 0}), line({0, 50}, {100, 50})};
  const std::vector<MatchedRun> runs = matched_runs(a, {line({0, 200}, {9, 200}), line({30, 51}, {60, 51})}, {}, kRuns);
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_EQ(runs[0].of_a.curve, 1u);
  EXPECT_EQ(runs[0].of_b.curve, 1u);
  EXPECT_NEAR(runs[0].of_a.from, 30, 1);
}

TEST(MatchedRuns, ASpeckFarAwayIsOfNoHarm) {
  const std::vector<Curve> a = {line({0, 0}, {100, 0}), line({9e5f, 9e5f}, {9e5f + 2, 9e5f})};
  EXPECT_FALSE(matched_runs(a, {line({30, 1}, {60, 1})}, {}, kRuns).empty());
}

TEST(MatchedRuns, WhatTwoRunsCoverCountsOnce) {
  const std::vector<Curve> a = {line({0, 0}, {100, 0})};
  const std::vector<Curve> b = {line({10, 1}, {60, 1}), line({40, -1}, {90, -1})};
  EXPECT_NEAR(covered_length_of_a(a, matched_runs(a, b, {}, kRuns)), 80, 3);
}

}  // namespace test_matched_runs
}  // namespace tessera
