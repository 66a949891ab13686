// Matches of two sets of curves in parts: whole, turned, cut, open, straight. Scores fall as shapes become less alike.
#include "core/recognition/curve_match.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/synthetic_shapes.h"

namespace tessera {
namespace test_curve_match {

float radius_of_shape(float angle) {
  return 1 + 0.3f * std::cos(2 * angle) + 0.2f * std::sin(3 * angle) + 0.12f * std::cos(5 * angle + 1);
}

float radius_of_another(float angle) {
  return 0.9f + 0.25f * std::cos(3 * angle + 2) + 0.15f * std::sin(4 * angle) + 0.1f * std::cos(7 * angle);
}

Similarity turned(float angle_rad, float scale) {
  return {std::cos(angle_rad) * scale, std::sin(angle_rad) * scale, 300, -50};
}

Curve posed(Curve curve, const Similarity& pose) {
  for (Vec2& p : curve.points) p = pose.apply(p);
  return curve;
}

/// The test shape at 100 px per unit.
Curve shape() { return posed({test::polar_curve(radius_of_shape), true}, {100, 0, 0, 0}); }

/// The open part of the shape between two fractions of its points.
Curve arc(float from, float to) {
  const std::vector<Vec2> points = shape().points;
  const auto at = [&](float part) { return points.begin() + std::ptrdiff_t(part * float(points.size())); };
  return {{at(from), at(to)}, false};
}

CurveMatch best_match(const Curve& a, const Curve& b) {
  const std::vector<CurveMatch> matches = matched_curves({{a}}, {{b}}, 1);
  return matches.empty() ? CurveMatch{} : matches.front();
}

void expect_pose(const Similarity& found, const Similarity& truth) {
  for (const Vec2 p : {Vec2{100, 0}, Vec2{-70, 60}, Vec2{0, -90}}) EXPECT_LT(norm(found.apply(p) - truth.apply(p)), 2);
}

TEST(CurveMatch, AShapeTurnedAndScaledMatchesWholly) {
  const Similarity truth = turned(2.1f, 0.4f);
  const CurveMatch match = best_match(posed(shape(), truth), shape());
  expect_pose(match.a_from_b, truth);
  EXPECT_GT(match.score, 0.97f);
  EXPECT_GT(match.similarity, 0.97f);
  EXPECT_GT(match.part_of_a, 0.98f);
  EXPECT_GT(match.part_of_b, 0.98f);
  ASSERT_EQ(match.runs.size(), 1u);
  EXPECT_FALSE(match.runs[0].reversed);
}

TEST(CurveMatch, AClippedShapeMatchesWhereItIsLeft) {
  Curve clipped = shape();
  for (Vec2& p : clipped.points) p.x = std::min(p.x, 0.f);
  const Similarity truth = turned(-1, 1.7f);
  const CurveMatch match = best_match(shape(), posed(clipped, truth));
  for (const Vec2 p : {Vec2{-70, 60}, Vec2{0, -90}}) EXPECT_LT(norm(match.a_from_b.apply(truth.apply(p)) - p), 2);
  const float left = length_of(clipped) / length_of(shape());
  EXPECT_LT(match.part_of_a, left);
  EXPECT_GT(match.part_of_a, 0.4f);
  EXPECT_GT(match.similarity, 0.95f);
}

TEST(CurveMatch, AnOpenCurveIsFoundInAShapeWhicheverWayItWasDrawn) {
  const Similarity truth = turned(0.8f, 2);
  const float part = length_of(arc(0.1f, 0.5f)) / length_of(shape());
  for (const bool backwards : {false, true}) {
    Curve open = arc(0.1f, 0.5f);
    if (backwards) std::reverse(open.points.begin(), open.points.end());
    const CurveMatch match = best_match(posed(shape(), truth), open);
    expect_pose(match.a_from_b, truth);
    EXPECT_GT(match.part_of_b, 0.97f);
    EXPECT_NEAR(match.part_of_a, part, 0.02f);
    ASSERT_EQ(match.runs.size(), 1u);
    EXPECT_EQ(match.runs[0].reversed, backwards);
    EXPECT_NEAR(match.runs[0].of_a.length(), 2 * length_of(open), 10);
  }
}

TEST(CurveMatch, OpenCurvesMatchInThePartThatTheyShare) {
  const CurveMatch match = best_match(arc(0.05f, 0.6f), posed(arc(0.25f, 0.9f), turned(1, 1)));
  const Similarity b_from_a = match.a_from_b.inverse();
  expect_pose(b_from_a, turned(1, 1));
  const float shared = length_of(arc(0.25f, 0.6f));
  EXPECT_NEAR(match.part_of_a, shared / length_of(arc(0.05f, 0.6f)), 0.04f);
  EXPECT_NEAR(match.part_of_b, shared / length_of(arc(0.25f, 0.9f)), 0.04f);
}

// An ellipse has no corners, so PADs have few levels on it; arcs give the pose.
TEST(CurveMatch, AThirdOfAnEllipseIsFoundWhereverItBegins) {
  Curve ellipse{{}, true};
  for (int i = 0; i < 480; ++i) {
    const float angle = 6.2831853f * float(i) / 480;
    ellipse.points.push_back({200 * std::cos(angle), 110 * std::sin(angle)});
  }
  for (int start = 0; start < 480; start += 60) {
    Curve third;
    for (int i = 0; i < 160; ++i) third.points.push_back(ellipse.points[std::size_t(start + i) % 480]);
    const CurveMatch match = best_match(ellipse, posed(third, turned(1, 0.7f)));
    EXPECT_GT(match.part_of_b, 0.9f) << "from point " << start;
    EXPECT_NEAR(match.a_from_b.scale(), 1 / 0.7f, 0.1f) << "from point " << start;
  }
}

TEST(CurveMatch, ScoresFallAsLessOfTheShapeIsLeft) {
  float score = 2, part = 2;
  for (const float changed : {0.f, 0.2f, 0.4f, 0.6f, 0.8f}) {
    const auto radius = [&](float angle) {
      const float last = test::kTwoPi * changed;
      const float weight = angle < last ? std::pow(std::sin(test::kTwoPi / 2 * angle / last), 0.5f) : 0.f;
      return radius_of_shape(angle) * (1 - weight) + radius_of_another(angle) * weight;
    };
    const Curve other = posed({test::polar_curve(radius), true}, turned(0.6f, 70));
    const CurveMatch match = best_match(shape(), other);
    EXPECT_LT(match.score, score - 0.05f) << changed;
    EXPECT_LT(match.part_of_a, part) << changed;
    score = match.score;
    part = match.part_of_a;
  }
  EXPECT_LT(score, 0.5f);
}

TEST(CurveMatch, StraightLinesMatchByTheirEndsBothWaysRound) {
  const Curve line{{{0, 0}, {30, 40}}, false};
  const std::vector<CurveMatch> matches = matched_curves({{line}}, {{{{{10, 10}, {10, 110}}, false}}}, 3);
  ASSERT_EQ(matches.size(), 2u);
  for (const CurveMatch& match : matches) {
    EXPECT_NEAR(match.a_from_b.scale(), 0.5f, 1e-3f);
    EXPECT_GT(match.score, 0.95f);
    EXPECT_GT(match.part_of_b, 0.95f);
  }
  EXPECT_NE(matches[0].runs[0].reversed, matches[1].runs[0].reversed);
}

TEST(CurveMatch, TellsPosesThatDifferTheBestFirst) {
  std::vector<Vec2> star = test::star_outline(5).curves[0];
  Curve curve{std::move(star), true};
  curve = posed(curve, {100, 0, 0, 0});
  const std::vector<CurveMatch> matches = matched_curves({{curve}}, {{curve}}, 7);
  ASSERT_GE(matches.size(), 5u);
  for (std::size_t k = 0; k < 5; ++k) EXPECT_GT(matches[k].score, 0.9f) << "a symmetry of the star";
  for (std::size_t k = 1; k < matches.size(); ++k) EXPECT_LE(matches[k].score, matches[k - 1].score);
  EXPECT_EQ(matched_curves({{curve}}, {{curve}}, 2).size(), 2u);
}

TEST(CurveMatch, ALineAndADiscHaveNothingInCommon) {
  const Curve disc = posed({test::polar_curve([](float) { return 1.f; }), true}, {100, 0, 0, 0});
  EXPECT_TRUE(matched_curves({{disc}}, {{{{{0, 0}, {100, 0}}, false}}}, 1).empty());
}

RC_GTEST_PROP(CurveMatch, a_match_keeps_within_the_curves, ()) {
  const float from = float(*rc::gen::inRange(0, 50)) / 100;
  const Curve b = posed(arc(from, from + 0.3f), turned(float(*rc::gen::inRange(0, 628)) / 100, 0.5f));
  const float length_a = length_of(shape()), length_b = length_of(b);
  const std::vector<CurveMatch> matches = matched_curves({{shape()}}, {{b}, 0.75f}, 3);
  RC_ASSERT(!matches.empty());
  for (const CurveMatch& match : matches) {
    RC_ASSERT(match.score > 0 && match.score <= 1 && match.similarity >= 0 && match.similarity <= 1);
    for (const MatchedRun& run : match.runs) {
      RC_ASSERT(run.of_a.from >= 0 && run.of_a.from <= length_a && run.of_a.length() <= length_a * 1.001f);
      RC_ASSERT(run.of_b.from >= 0 && run.of_b.to <= length_b * 1.001f && run.of_b.length() > 0);
    }
  }
}

}  // namespace test_curve_match
}  // namespace tessera
