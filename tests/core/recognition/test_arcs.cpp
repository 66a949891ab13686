// A query's arcs are found among the arcs of a library's shapes, and give the pose.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "core/recognition/arc_poses.h"
#include "core/recognition/query_arcs.h"
#include "support/synthetic_library.h"

namespace tessera {
namespace test_arcs {

constexpr PadParameters kPad;
constexpr float kScale_px = 150;

const std::vector<Shape>& library() {
  static const std::vector<Shape> shapes = test::synthetic_library(12);
  return shapes;
}

std::vector<ShapeModel> models() {
  std::vector<ShapeModel> made;
  for (const Shape& shape : library()) made.push_back(make_shape_model(shape, kPad, kPad, {3, 4}));
  return made;
}

KnownShapes known_shapes() {
  return KnownShapes(ShapeId(0), models(), std::vector<float>(library().size(), kScale_px), kPad.levels);
}

Similarity turned(float angle_rad, float scale) {
  return {std::cos(angle_rad) * scale, std::sin(angle_rad) * scale, 20, -7};
}

ArcPoints bent_arc(float bend) {
  ArcPoints points;
  for (std::size_t i = 0; i < kArcPoints; ++i) {
    const float angle = bend * float(i) / (kArcPoints - 1);
    points[i] = {std::sin(angle) / bend, (1 - std::cos(angle)) / bend};  // the arc has length 1
  }
  return points;
}

RC_GTEST_PROP(ArcSignature, KnowsNeitherPlaceNorRotationNorSize, ()) {
  const float bend = 0.01f * float(*rc::gen::inRange(-300, 300)) + 0.001f;
  const Similarity pose = turned(0.001f * float(*rc::gen::inRange(0, 6283)), 0.1f * float(*rc::gen::inRange(1, 500)));
  ArcPoints moved = bent_arc(bend);
  for (Vec2& p : moved) p = pose.apply(p);
  const auto signature = arc_signature(bent_arc(bend), 1), of_moved = arc_signature(moved, pose.scale());
  RC_ASSERT(signature && of_moved);
  for (std::size_t i = 0; i < signature->size(); ++i) {
    RC_ASSERT(std::abs((*signature)[i] - (*of_moved)[i]) < 1e-3f);
    RC_ASSERT((*signature)[i] >= 0 && (*signature)[i] <= 1);
  }
}

TEST(ArcSignature, TellsLeftFromRightAndTheDirection) {
  const ArcSignature left = *arc_signature(bent_arc(1), 1), right = *arc_signature(bent_arc(-1), 1);
  EXPECT_GT(left[1], 0.55f);
  EXPECT_LT(right[1], 0.45f);
  ArcPoints corner = {{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {4, 1}}};
  const ArcSignature forth = *arc_signature(corner, 5);
  std::reverse(corner.begin(), corner.end());
  const ArcSignature back = *arc_signature(corner, 5);
  float difference = 0;
  for (std::size_t i = 0; i < forth.size(); ++i) difference = std::max(difference, std::abs(forth[i] - back[i]));
  EXPECT_GT(difference, 0.05f);
}

TEST(ArcSignature, IsNoneOfAnArcThatComesBackOrHasNoLength) {
  ArcPoints round;
  for (std::size_t i = 0; i < kArcPoints; ++i) {
    const float angle = 2 * std::numbers::pi_v<float> * float(i) / (kArcPoints - 1);
    round[i] = {0, std::cos(angle)};
  }
  EXPECT_FALSE(arc_signature(round, 4));
  EXPECT_FALSE(arc_signature(bent_arc(1), 0));
  EXPECT_FALSE(arc_signature(ArcPoints{}, 1));
}

TEST(KnownArcs, LieOnTheBoundaryAndHaveTheirLength) {
  const std::vector<ShapeModel> shapes = models();
  const KnownArcs arcs(shapes, std::vector<float>(shapes.size(), kScale_px), kPad.levels);
  const auto starts = std::uint32_t(shapes[0].levels.back().samples.size());
  for (const std::uint32_t place : {0u, 5 * starts * kArcLengths + 2 * starts + 7, 11 * starts * kArcLengths + 99}) {
    const std::uint32_t shape = arcs.shape_of(place);
    EXPECT_EQ(shape, place / (starts * kArcLengths));
    const float length = arcs.length_of(place), powers = std::log(length * kScale_px) / std::log(kArcStep);
    EXPECT_NEAR(powers, std::round(powers), 1e-3f) << "lengths are powers in px of the drawing";
    const ArcPoints points = arcs.points_of(place, shapes[shape]);
    float chords = 0;
    for (std::size_t i = 0; i < kArcPoints; ++i) {
      if (i > 0) chords += norm(points[i] - points[i - 1]);
      float nearest = 9;
      for (const Vec2 p : library()[shape].outline.curves[0]) nearest = std::min(nearest, norm(p - points[i]));
      EXPECT_LT(nearest, 0.03f) << "place " << place;
    }
    EXPECT_LT(chords, 1.01f * length);
    EXPECT_GT(chords, 0.8f * length);
  }
}

/// A part of a shape's outline, moved by `pose`.
Curve part_of(std::size_t shape, const Similarity& pose, std::size_t first, std::size_t count) {
  const std::vector<Vec2>& points = library()[shape].outline.curves[0];
  Curve part;
  for (std::size_t i = 0; i < count; ++i) part.points.push_back(pose.apply(points[(first + i) % points.size()]));
  return part;
}

/// A quarter of a circle of radius 80 px.
Curve quarter() {
  Curve curve;
  for (int i = 0; i <= 90; ++i) {
    const float angle = std::numbers::pi_v<float> * float(i) / 180;
    curve.points.push_back({80 * std::cos(angle), 80 * std::sin(angle)});
  }
  return curve;
}

TEST(QueryArcs, AreOfTheLengthsAskedForAndLieOnTheCurve) {
  const std::vector<QueryArc> arcs = query_arcs(Query({quarter()}, {}), 3, 2);
  ASSERT_FALSE(arcs.empty());
  float least_angle = 2, largest_angle = 0;
  for (const QueryArc& arc : arcs) {
    EXPECT_TRUE(arc.length == 24 || arc.length == 48 || arc.length == 96) << arc.length;
    for (const Vec2 p : arc.points) EXPECT_NEAR(norm(p), 80, 0.5f);
    if (arc.length != 24) continue;
    least_angle = std::min(least_angle, std::atan2(arc.points.front().y, arc.points.front().x));
    largest_angle = std::max(largest_angle, std::atan2(arc.points.back().y, arc.points.back().x));
  }
  EXPECT_NEAR(least_angle, 0, 0.01f) << "the first begins with the curve";
  EXPECT_NEAR(largest_angle, std::numbers::pi / 2, 0.01f) << "the last ends with it";
}

TEST(QueryArcs, AreNotTakenOfThousandsOfCrumbs) {
  std::vector<Curve> curves{quarter()};
  for (int i = 0; i < 1000; ++i) {
    Curve crumb = quarter();
    for (Vec2& p : crumb.points) p = p * 0.2f + Vec2{0, 100};
    curves.push_back(crumb);
  }
  EXPECT_TRUE(query_arcs(Query(curves, {}), 3, 2).empty());
}

/// A drawing seen between bars: each of twelve curves is looked up as often as a single one, though it is a small part of all.
TEST(QueryArcs, BeginAtManyPlacesOfEachOfManyShortCurves) {
  const std::size_t alone = query_arcs(Query({quarter()}, {}), 3, 2).size();
  std::vector<Curve> curves(12, quarter());
  for (std::size_t i = 0; i < curves.size(); ++i) {
    for (Vec2& p : curves[i].points) p.x += 1000 * float(i);
  }
  EXPECT_GT(query_arcs(Query(curves, {}), 3, 2).size(), 12 * alone / 2);
}

TEST(QueryArcs, AreNotStraight) {
  const Curve corner{{{0, 0}, {100, 0}, {100, 80}}, false};
  const std::vector<QueryArc> arcs = query_arcs(Query({corner}, {}), 3, 2);
  ASSERT_FALSE(arcs.empty());
  for (const QueryArc& arc : arcs) {
    EXPECT_LT(arc.points.front().y, 1.f) << "begins before the corner";
    EXPECT_GT(arc.points.back().x, 99.f) << "ends after it";
  }
  const Curve line{{{0, 0}, {300, 10}}, false};
  EXPECT_TRUE(query_arcs(Query({line}, {}), 3, 2).empty());
}

/// A seventh of the boundary finds its shape in the right pose.
RC_GTEST_PROP(ArcPoses, FindTheShapeOfAPartOfItsBoundary, ()) {
  static const KnownShapes known = known_shapes();
  const auto shape = std::size_t(*rc::gen::inRange(0, 12));
  const float factor = 0.1f * float(*rc::gen::inRange(6, 20));
  const Similarity pose = turned(0.001f * float(*rc::gen::inRange(0, 6283)), kScale_px* factor);
  const std::size_t count = library()[shape].outline.curves[0].size();
  const Query query({part_of(shape, pose, std::size_t(*rc::gen::inRange(0, int(count))), count / 7)}, {});
  for (const std::optional<float> told : {std::optional<float>(factor), std::optional<float>()}) {
    const PossibleScales scales(query, known, told);
    const std::vector<PosedShape> found = arc_poses(query, known, scales);
    const bool right = std::any_of(found.begin(), found.end(), [&](const PosedShape& p) {
      return p.shape == shape && norm(p.query_from_shape.apply(Vec2{}) - pose.apply(Vec2{})) < 0.4f * pose.scale();
    });
    RC_ASSERT(right);
    for (const PosedShape& p : found)
      RC_ASSERT(!told || std::abs(p.query_from_shape.scale() / pose.scale() - 1) < 0.4f);
  }
}

}  // namespace test_arcs
}  // namespace tessera
