// A shape is recognised when turned, scaled or clipped, at the right place, in lots of any size. Further tests: the poses, maps and least
// squares behind it.
#include "core/recognition/recognition.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "core/recognition/boundary_fit.h"
#include "core/recognition/point_fit.h"
#include "support/synthetic_library.h"

namespace tessera {
namespace test_recognition {

constexpr PadParameters kPad;
const std::vector<int> kLevelsUsed = {1, 2, 3, 4};
constexpr float kDrawnScale_px = 150;

const std::vector<Shape>& library() {
  static const std::vector<Shape> shapes = test::synthetic_library(40);
  return shapes;
}

KnownShapes known_shapes(std::size_t begin, std::size_t end) {
  std::vector<ShapeModel> models;
  for (std::size_t i = begin; i < end; ++i) models.push_back(make_shape_model(library()[i], kPad, kPad, kLevelsUsed));
  return KnownShapes(ShapeId(begin), std::move(models), std::vector<float>(end - begin, kDrawnScale_px), kPad.levels);
}

const KnownShapes& all_shapes() {
  static const KnownShapes shapes = known_shapes(0, library().size());
  return shapes;
}

Outline outline_of(ShapeId id) { return library()[index_of(id)].outline; }

Similarity turned(float angle_rad, float scale_px) {
  return {std::cos(angle_rad) * scale_px, std::sin(angle_rad) * scale_px, 40, -30};
}

Curve posed_outline(std::size_t shape, const Similarity& pose) {
  Curve curve{library()[shape].outline.curves.front(), true};
  for (Vec2& p : curve.points) p = pose.apply(p);
  return curve;
}

/// The visible parts of an outline, right of a line x = const that hides `part` of its width. The line itself is not included.
std::vector<Curve> clipped(const Curve& outline, float part) {
  float low = outline.points[0].x, high = low;
  for (const Vec2 p : outline.points) low = std::min(low, p.x), high = std::max(high, p.x);
  const float edge = low + part * (high - low);
  std::size_t start = 0;
  while (outline.points[start].x > edge) ++start;
  std::vector<Curve> arcs;
  Curve arc{{}, false};
  for (std::size_t k = 1; k <= outline.points.size(); ++k) {
    const Vec2 p = outline.points[(start + k) % outline.points.size()];
    if (p.x > edge) {
      arc.points.push_back(p);
    } else if (!arc.points.empty()) {
      if (arc.points.size() > 8) arcs.push_back(arc);
      arc.points.clear();
    }
  }
  return arcs;
}

void expect_pose(const Similarity& found, const Similarity& truth, float tolerance_px) {
  for (const Vec2 p : {Vec2{0.5f, 0}, Vec2{-0.5f, 0.3f}, Vec2{0, -0.5f}}) {
    EXPECT_LT(norm(found.apply(p) - truth.apply(p)), tolerance_px);
  }
}

TEST(Recognition, FindsAShapeTurnedAndScaled) {
  for (std::size_t i = 0; i < library().size(); i += 3) {
    const Similarity truth = turned(0.7f * float(i), 60 + 7 * float(i));
    const Query query({posed_outline(i, truth)}, {});
    const auto found = recognised(query, all_shapes(), {}, outline_of);
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(index_of(found[0].shape), i);
    EXPECT_GT(found[0].similarity, 0.9f);
    if (i > 0) expect_pose(found[0].query_from_shape, truth, 0.02f * truth.scale());  // shape 0 is a star: five poses
  }
}

TEST(Recognition, FindsAShapeOfWhichHalfIsHidden) {
  int right = 0, tried = 0;
  for (std::size_t i = 0; i < library().size(); i += 3, ++tried) {
    const Similarity truth = turned(0.9f * float(i), kDrawnScale_px);
    const Query query(clipped(posed_outline(i, truth), 0.5f), {});
    const auto found = recognised(query, all_shapes(), {}, outline_of);
    right += !found.empty() && index_of(found[0].shape) == i;
  }
  EXPECT_GE(right, tried - 1);
}

/// Noise of 3 px at points 1 px apart makes the outline several times longer.
TEST(Recognition, FindsANoisyShapeWithoutItsNoise) {
  Curve outline = posed_outline(7, turned(0.4f, 120));
  outline = resampled(outline, int(length_of(outline)));
  std::mt19937 bits(1);
  std::normal_distribution<float> noise(0, 3);
  const std::vector<Vec2> tangents = tangents_of(outline);
  for (std::size_t i = 0; i < tangents.size(); ++i) {
    outline.points[i] = outline.points[i] + Vec2{-tangents[i].y, tangents[i].x} * noise(bits);
  }
  QuerySettings without_its_noise;
  without_its_noise.without_noise = true;
  const auto with = recognised(Query({outline}, {}), all_shapes(), {}, outline_of);
  const auto without = recognised(Query({outline}, without_its_noise), all_shapes(), {}, outline_of);
  ASSERT_FALSE(without.empty());
  EXPECT_EQ(index_of(without[0].shape), 7u);
  EXPECT_GT(without[0].similarity, 0.3f);
  EXPECT_TRUE(with.empty() || with[0].similarity < 0.7f * without[0].similarity);
  EXPECT_LT(without[0].query_length, 0.6f * length_of(outline)) << "the length without noise";
  std::set<std::size_t> each;
  for (const Recognition& r : without) EXPECT_TRUE(each.insert(index_of(r.shape)).second) << "told twice";
}

TEST(Recognition, AKnownScaleExcludesOthers) {
  const Similarity truth = turned(1, 2 * kDrawnScale_px);
  const Query query({posed_outline(5, truth)}, {});
  const auto at_scale = recognised(query, all_shapes(), {.query_per_drawn_px = 2}, outline_of);
  ASSERT_FALSE(at_scale.empty());
  EXPECT_EQ(index_of(at_scale[0].shape), 5u);
  for (const Recognition& other : recognised(query, all_shapes(), {.query_per_drawn_px = 1}, outline_of)) {
    EXPECT_LT(other.similarity, 0.7f);
    EXPECT_NEAR(other.query_from_shape.scale(), kDrawnScale_px, 0.03f * kDrawnScale_px);
  }
}

TEST(Recognition, TellsTheBestFirstAndNoMoreThanAskedFor) {
  const Query query({posed_outline(7, turned(2, 90))}, {});
  const auto found = recognised(query, all_shapes(), {.query_per_drawn_px = {}, .most = 3}, outline_of);
  ASSERT_EQ(found.size(), 3u);
  for (std::size_t i = 1; i < found.size(); ++i) EXPECT_TRUE(found[i - 1] < found[i]);
  const auto all = recognised(query, all_shapes(), {}, outline_of);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(all[i].shape, found[i].shape);
}

TEST(Recognition, NumbersShapesOfTheLibraryInALot) {
  const Query query({posed_outline(25, turned(2, 90))}, {});
  const auto found = recognised(query, known_shapes(20, 30), {}, outline_of);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(index_of(found[0].shape), 25u);
}

TEST(Recognition, AStraightLineIsNothing) {
  const Query line({{{{0, 0}, {300, 10}}, false}}, {});
  EXPECT_TRUE(recognised(line, all_shapes(), {}, outline_of).empty());
}

TEST(Recognition, FarPointsAndManyPointsAreOfNoHarm) {
  std::vector<Curve> curves;
  Curve dense{{}, true};
  for (int i = 0; i < 1000000; ++i) {
    const float a = 2 * std::numbers::pi_v<float> * float(i) / 1e6f;
    dense.points.push_back({100 * std::cos(a) + 20 * std::cos(7 * a), 80 * std::sin(a)});
  }
  curves.push_back(dense);
  curves.push_back({{{9e5f, 9e5f}, {9e5f + 1, 9e5f}}, false});
  const Query query(curves, {});
  EXPECT_NO_THROW(recognised(query, all_shapes(), {}, outline_of));
}

TEST(PointFit, FindsTheTransformOfRandomPoints) {
  const Similarity truth = turned(2.5f, 3);
  const std::vector<Vec2> shape = {{0, 0}, {1, 0}, {0.4f, 2}, {-1, 0.5f}};
  std::vector<Vec2> query;
  for (const Vec2 p : shape) query.push_back(truth.apply(p));
  const PointFit fit = fit_points(shape, query);
  EXPECT_NEAR(fit.residual, 0, 1e-3);
  expect_pose(fit.query_from_shape, truth, 1e-3f);
  EXPECT_EQ(fit_points(std::vector<Vec2>(3), query).residual, 1);
}

TEST(BoundaryFit, MovesAShapeOntoItsCurve) {
  const Similarity truth = turned(0.4f, 100);
  const Query query({posed_outline(3, truth)}, {});
  const ShapeModel& model = all_shapes().model(3);
  const BoundaryPoints points{model.boundary, model.tangent, model.perimeter / kBoundaryPoints};
  Similarity off = turned(0.47f, 104);
  off.tx += 2;
  const Similarity found = refined_pose(query, points, off, 8, 15, 2, {50, 200});
  expect_pose(found, truth, 1);
  EXPECT_GT(followed_part(query, points, found), followed_part(query, points, off));
  EXPECT_GT(followed_part(query, points, truth), 0.9f);
  EXPECT_NEAR(refined_pose(query, points, off, 8, 15, 2, {50, 90}).scale(), 90, 0.1f) << "a limit";
}

RC_GTEST_PROP(CurveMap, knows_the_nearest_point, ()) {
  const Curve curve = resampled(posed_outline(*rc::gen::inRange<std::size_t>(0, 40), turned(0, 100)), 800);
  const CurveMap map({curve}, 2, 20);
  const float angle = float(*rc::gen::inRange(0, 628)) / 100;
  const Vec2 on = curve.points[*rc::gen::inRange<std::size_t>(0, 800)];
  const Vec2 p = on + Vec2{std::cos(angle), std::sin(angle)} * (float(*rc::gen::inRange(0, 300)) / 10);
  float nearest = 1e9f;
  for (const Vec2 q : curve.points) nearest = std::min(nearest, norm(p - q));
  const CurveMap::Nearest found = map.nearest(p);
  if (nearest < 18) {
    RC_ASSERT(found.distance < nearest + 1.5f);  // of two branches at similar distances it may find the other one
    RC_ASSERT(found.distance > nearest - 1.f);
    RC_ASSERT(std::abs(norm(p - found.point) - found.distance) < 1e-3f);
  }
  if (nearest > 22) RC_ASSERT(found.distance > 1e9f);
}

TEST(CurveMap, SaysWhereAnOpenCurveEnds) {
  const CurveMap map({resampled({{{0, 0}, {50, 0}}, false}, 100)}, 1, 10);
  EXPECT_TRUE(map.nearest({-3, 1}).at_end);
  EXPECT_FALSE(map.nearest({20, 3}).at_end);
  EXPECT_NEAR(map.nearest({20, 3}).along, 20, 1e-3);
  EXPECT_NEAR(map.nearest({20, 3}).distance, 3, 1e-4);
  EXPECT_FLOAT_EQ(map.length(), 50);
}

}  // namespace test_recognition
}  // namespace tessera
