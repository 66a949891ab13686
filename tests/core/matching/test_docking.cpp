#include "core/matching/docking.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <set>

#include "core/base/portable_math.h"
#include "core/field/free_field.h"
#include "core/geometry/closed_curve.h"
#include "core/matching/matcher.h"
#include "core/matching/pair_selection.h"
#include "core/matching/refinement.h"
#include "core/settings/tuning.h"
#include "support/random_curves.h"
#include "support/synthetic_library.h"

namespace tessera {
namespace test_docking {

Similarity random_similarity(float min_scale, float max_scale) {
  const float scale = min_scale + (max_scale - min_scale) * 0.001f * float(*rc::gen::inRange(0, 1000));
  const float angle = 0.001f * float(*rc::gen::inRange(0, 6283));
  return {scale * std::cos(angle), scale * std::sin(angle), float(*rc::gen::inRange(-500, 500)),
          float(*rc::gen::inRange(-500, 500))};
}

CollageSettings settings() {
  CollageSettings s;
  s.pieces.min_scale_px = 20;
  s.pieces.max_scale_px = 120;
  return s;
}

/// A free region that is exactly the hole of a piece.
CanvasField hole_of(const Shape& shape, const Similarity& pose, int size) {
  CanvasField field{Grid<float>(size, size), {0.5f, 0.5f}};
  const Similarity back = pose.inverse();
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      field.value(x, y) = -pose.scale() * shape.field.at(back.apply({float(x) + 0.5f, float(y) + 0.5f}));
    }
  }
  return field;
}

/// The context's only stance.
const Stance& stance_of(const MatchingContext& context) { return context.stances[0]; }

Stance stance_of(const PoseRange& poses) {
  Stance stance;
  stance.poses = poses;
  return stance;
}

TEST(AlignPyramids, RecoversTheSimilarity) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<Vec2> curve =
        gaussian_smoothed(test::random_curve(*rc::gen::inRange<std::uint32_t>(1, 1u << 30), 1024), 0.05f);
    const ArclengthPyramid shape = sample_pyramids(curve, 0.05f, 16, PadParameters{})[*rc::gen::inRange(0, 16)];
    const Similarity truth = random_similarity(20, 120);
    ArclengthPyramid target = shape;
    for (Vec2& p : target.keypoint) p = truth.apply(p);
    const Stance any[] = {stance_of(PoseRange{19, 121, {}})};
    const Alignment found = align_pyramids(shape.keypoint, target, 5, {19, 121}, any);
    RC_ASSERT(found.valid);
    RC_ASSERT(std::abs(found.canvas_from_shape.a - truth.a) < 0.01f);
    RC_ASSERT(std::abs(found.canvas_from_shape.b - truth.b) < 0.01f);
    RC_ASSERT(norm(found.canvas_from_shape.translation() - truth.translation()) < 0.05f);
    RC_ASSERT(!align_pyramids(shape.keypoint, target, 5, {truth.scale() * 1.01f, 500}, any).valid);
  }));
}

/// Of all poses with an allowed rotation and scale it is the least-squares one: no small step within the range is better.
TEST(AlignPyramids, IsTheBestOfTheAllowedPoses) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<Vec2> curve =
        gaussian_smoothed(test::random_curve(*rc::gen::inRange<std::uint32_t>(1, 1u << 30), 1024), 0.05f);
    const ArclengthPyramid shape = sample_pyramids(curve, 0.05f, 16, PadParameters{})[*rc::gen::inRange(0, 16)];
    const Similarity truth = random_similarity(30, 100);
    ArclengthPyramid target = shape;
    for (Vec2& p : target.keypoint) p = truth.apply(p);
    const float angle = truth.rotation_rad() + 0.01f * float(*rc::gen::inRange(2, 10));
    const float least_scale = truth.scale() * (1 + 0.01f * float(*rc::gen::inRange(-5, 6)));
    const PoseRange poses{least_scale, 200, direction_range(angle, angle + 0.3f)};
    const Alignment found = align_pyramids(shape.keypoint, target, 5, {1, 300}, std::vector{stance_of(poses)});
    RC_ASSERT(found.valid);
    RC_ASSERT(poses.contains(found.canvas_from_shape));
    RC_ASSERT(std::abs(std::remainder(found.canvas_from_shape.rotation_rad() - angle, 6.2831853f)) < 1e-3f);
    const auto squares = [&](const Similarity& s) {
      float sum = 0;
      for (int i = 0; i < 11; ++i) {
        const Vec2 d = s.apply(shape.keypoint[i]) - target.keypoint[i];
        sum += dot(d, d);
      }
      return sum;
    };
    const float least = squares(found.canvas_from_shape);
    for (int k = 0; k < 4; ++k) {
      Similarity other = found.canvas_from_shape;
      if (k < 2) other.tx += k == 0 ? 0.5f : -0.5f;
      if (k >= 2) other.ty += k == 2 ? 0.5f : -0.5f;
      RC_ASSERT(squares(other) > least);
    }
  }));
}

TEST(TangentDocking, TakesOnlyPointsThatAgreeWhereRotationsAreFew) {
  const std::vector<Shape> shapes = test::synthetic_library(4);
  CollageSettings s = settings();
  s.pieces.min_rotation_rad = s.pieces.max_rotation_rad = 0.4f;
  const MatchingContext context = make_matching_context(s, 4);
  const auto models = test::models_of(shapes, context, 0, 4);
  TargetSample sample;
  sample.id = SampleId{77};
  sample.position = {200, 100};
  sample.tangent = {0.6f, 0.8f};
  int docked = 0;
  std::set<int> points;
  for (std::uint32_t i = 0; i < 400; ++i) {
    const TangentDraw draw = draw_tangent(context, sample, i);
    const ShapeModel& model = models[index_of(draw.shape)];
    const int point = docked_point(model, draw, sample, stance_of(context).docked_rotations);
    if (point == kNoPoint) continue;
    ++docked;
    points.insert(point);
    const Similarity pose = tangent_docking(model, point, draw.scale_px, sample, stance_of(context).poses);
    EXPECT_NEAR(pose.rotation_rad(), 0.4f, 1e-5f);
    EXPECT_LT(norm(pose.apply(model.boundary[point]) - sample.position), 0.01f);
    const Vec2 direction = pose.apply_direction(model.tangent[point]) * (1 / draw.scale_px);
    EXPECT_GT(dot(direction, sample.tangent), std::cos(kDockingTurn_rad) - 1e-3f);
  }
  EXPECT_GT(docked, 350) << "every shape has a side in every direction";
  EXPECT_GT(points.size(), 10u);
}

TEST(TangentDocking, AlignsTheFrames) {
  const std::vector<Shape> shapes = test::synthetic_library(4);
  const MatchingContext context = make_matching_context(settings(), 4);
  const auto models = test::models_of(shapes, context, 0, 4);
  TargetSample sample;
  sample.id = SampleId{77};
  sample.position = {200, 100};
  sample.tangent = {0.6f, 0.8f};
  std::array<int, 4> drawn{};
  for (std::uint32_t i = 0; i < 400; ++i) {
    const TangentDraw draw = draw_tangent(context, sample, i);
    ASSERT_LT(index_of(draw.shape), 4u);
    ASSERT_GE(draw.scale_px, 20.f);
    ASSERT_LE(draw.scale_px, 120.001f);
    ++drawn[index_of(draw.shape)];
    const ShapeModel& model = models[index_of(draw.shape)];
    const int point = docked_point(model, draw, sample, stance_of(context).docked_rotations);
    const Similarity pose = tangent_docking(model, point, draw.scale_px, sample, stance_of(context).poses);
    EXPECT_LT(norm(pose.apply(model.boundary[point]) - sample.position), 0.01f);
    const Vec2 direction = pose.apply_direction(model.tangent[point]) * (1 / draw.scale_px);
    EXPECT_LT(norm(direction - sample.tangent), 1e-3f);
  }
  for (const int count : drawn) EXPECT_GT(count, 60);
}

TEST(TangentDocking, DrawsDependOnSampleAndPass) {
  const MatchingContext context = make_matching_context(settings(), 1000);
  TargetSample a;
  TargetSample b;
  b.pass = 1;
  int same = 0;
  for (std::uint32_t i = 0; i < 100; ++i)
    same += draw_tangent(context, a, i).shape == draw_tangent(context, b, i).shape;
  EXPECT_LT(same, 5);
}

TEST(PortableExp2, IsCloseToTheTruth) {
  for (float x = -8; x < 8; x += 0.013f) EXPECT_NEAR(portable_exp2(x) / std::exp2(x), 1, 2e-6f);
}

TEST(PortableLog, IsCloseToTheTruth) {
  for (double x = 1e-6; x < 1e9; x *= 1.037) {
    EXPECT_NEAR(portable_log(x), std::log(x), 1e-9 * std::abs(std::log(x)) + 1e-12) << x;
  }
  EXPECT_EQ(portable_log(1), 0);
}

TEST(DockingKey, PrefersThePoseThatFits) {
  const Shape shape = test::make_library_shape("bean", test::bean_outline());
  const MatchingContext context = make_matching_context(settings(), 1);
  const ShapeModel model = test::models_of({shape}, context, 0, 1).front();
  const Similarity pose{70, 20, 128, 128};
  const CanvasField hole = hole_of(shape, pose, 256);
  const float fit = docking_key(model, pose, FieldView(hole), 120);
  Similarity off = pose;
  off.tx += 40;
  EXPECT_GT(fit, 0.7f);
  EXPECT_LT(docking_key(model, off, FieldView(hole), 120), 0);
}

TEST(Refine, FindsBackIntoTheHole) {
  const Shape shape = test::make_library_shape("bean", test::bean_outline());
  const MatchingContext context = make_matching_context(settings(), 1);
  const ShapeModel model = test::models_of({shape}, context, 0, 1).front();
  EXPECT_TRUE(rc::check([&] {
    const float angle = 0.001f * float(*rc::gen::inRange(0, 6283));
    const Similarity truth{70 * std::cos(angle), 70 * std::sin(angle), 128, 128};
    const CanvasField hole = hole_of(shape, truth, 256);
    Similarity pose = truth;
    pose.tx += float(*rc::gen::inRange(-3, 4));
    pose.ty += float(*rc::gen::inRange(-3, 4));
    pose.a *= 1.02f;
    RC_ASSERT(refine(pose, model, FieldView(hole), stance_of(context).poses, context.hard_depth_px));
    RC_ASSERT(depth_px(pose, model, FieldView(hole)) <= 0.8f);
    RC_ASSERT(norm(pose.translation() - truth.translation()) < 1.5f);
    RC_ASSERT(std::abs(pose.scale() / truth.scale() - 1) < 0.03f);
    const DockingTerms terms = docking_terms(pose, model, FieldView(hole), context);
    RC_ASSERT(terms.matched_px > 0.95f * model.perimeter * pose.scale());
    RC_ASSERT(terms.gap_px2 + terms.overlap_px2 < 0.05f * pose.scale() * pose.scale());
  }));
}

TEST(Refine, RejectsWhatCannotFit) {
  const Shape shape = test::make_library_shape("star", test::star_outline(5));
  const MatchingContext context = make_matching_context(settings(), 1);
  const ShapeModel model = test::models_of({shape}, context, 0, 1).front();
  const CanvasField hole = hole_of(shape, {10, 0, 64, 64}, 128);  // below the smallest size of a piece
  Similarity pose{20, 0, 64, 64};
  EXPECT_FALSE(refine(pose, model, FieldView(hole), stance_of(context).poses, context.hard_depth_px));
}

/// Grows the piece as far as it can.
void grow(Similarity& pose, const ShapeModel& model, const CanvasField& hole, const MatchingContext& context) {
  while (grow_step(pose, model, FieldView(hole), stance_of(context).poses, context.hard_depth_px)) {
  }
}

TEST(Grow, StopsAtTheNeighbours) {
  const Shape shape = test::make_library_shape("bean", test::bean_outline());
  const MatchingContext context = make_matching_context(settings(), 1);
  const ShapeModel model = test::models_of({shape}, context, 0, 1).front();
  const CanvasField hole = hole_of(shape, {70, 0, 128, 128}, 256);
  Similarity pose{62, 0, 128, 128};
  grow(pose, model, hole, context);
  EXPECT_GT(pose.scale(), 67.f);
  EXPECT_LE(depth_px(pose, model, FieldView(hole)), 0.8f);
}

/// From poses that are far too deep, where steps are as long as they may be.
TEST(Descend, MovesNoPointFartherThanTheLongestWay) {
  const Shape shape = test::make_library_shape("bean", test::bean_outline());
  const MatchingContext context = make_matching_context(settings(), 1);
  const ShapeModel model = test::models_of({shape}, context, 0, 1).front();
  const PoseRange poses = stance_of(context).poses;
  const CanvasField hole = hole_of(shape, {60, 0, 128, 128}, 256);
  float longest_part = 0;
  EXPECT_TRUE(rc::check([&] {
    const float scale_px = poses.min_scale_px + 0.1f * float(*rc::gen::inRange(0, 300));
    const float angle_rad = 0.01f * float(*rc::gen::inRange(0, 628));
    const Similarity from{scale_px * std::cos(angle_rad), scale_px * std::sin(angle_rad),
                          128 + float(*rc::gen::inRange(-30, 31)), 128 + float(*rc::gen::inRange(-30, 31))};
    for (const Descent& descent : {kSettle, kGrow}) {
      Similarity to = from;
      descend(to, model, FieldView(hole), descent, poses);
      const float most_px = longest_way_px(descent, model.radius * poses.min_scale_px);
      for (const Vec2& p : model.boundary) {
        const float way_px = norm(to.apply(p) - from.apply(p));
        RC_ASSERT(way_px <= most_px);
        longest_part = std::max(longest_part, way_px / most_px);
      }
    }
  }));
  EXPECT_GT(longest_part, 0.3f) << "the bound says nothing";
}

TEST(Rotation, IsLimitedToItsRange) {
  CollageSettings s = settings();
  s.pieces.min_rotation_rad = -0.5f;
  s.pieces.max_rotation_rad = 0.2f;
  const MatchingContext context = make_matching_context(s, 1);
  const auto turned = [](float rad) { return Similarity{30 * std::cos(rad), 30 * std::sin(rad), 0, 0}; };
  EXPECT_TRUE(stance_of(context).poses.contains(turned(-0.49f)));
  EXPECT_TRUE(stance_of(context).poses.contains(turned(0.19f)));
  EXPECT_FALSE(stance_of(context).poses.contains(turned(-0.51f)));
  EXPECT_FALSE(stance_of(context).poses.contains(turned(0.21f)));
  EXPECT_FALSE(stance_of(context).poses.contains(turned(3.f)));
}

/// For any interval, also a single angle: a pose outside comes back to its nearest bound, and a pose inside stays.
TEST(PoseRange, PullsInByAsLittleAsNeeded) {
  EXPECT_TRUE(rc::check([] {
    const float low = 0.001f * float(*rc::gen::inRange(-3141, 3141));
    const float width = *rc::gen::element(0.f, 1e-4f, 0.003f, 0.2f, 2.f, 4.f, 6.f);
    const float min_scale = float(*rc::gen::inRange(2, 4000));
    const float max_scale = min_scale * *rc::gen::element(1.0001f, 1.05f, 8.f);
    const PoseRange poses{min_scale, max_scale, direction_range(low, low + width)};
    const Similarity before = random_similarity(min_scale * 0.5f, max_scale * 2);
    Similarity after = before;
    poses.pull_in(after);
    RC_ASSERT(poses.contains(after));
    RC_ASSERT(after.translation() == before.translation());
    RC_ASSERT(after.scale() >= min_scale);
    RC_ASSERT(after.scale() <= max_scale);
    const double turn = std::abs(std::remainder(double(after.rotation_rad()) - before.rotation_rad(), 6.283185307));
    const double middle = std::remainder(double(before.rotation_rad()) - (low + 0.5 * width), 6.283185307);
    RC_ASSERT(std::abs(turn - std::max(0., std::abs(middle) - 0.5 * width)) < 1e-5);
    Similarity again = after;
    poses.pull_in(again);
    RC_ASSERT(norm({again.a - after.a, again.b - after.b}) <= 1e-6f * after.scale());
  }));
}

TEST(PoseRange, KnowsHowFarAPoseMayTurn) {
  EXPECT_TRUE(rc::check([] {
    const float low = 0.001f * float(*rc::gen::inRange(-3141, 3141));
    const float width = 0.001f * float(*rc::gen::inRange(0, 1500));
    const PoseRange poses{1, 200, direction_range(low, low + width)};
    const float at = low + width * 0.01f * float(*rc::gen::inRange(0, 101));
    const TurnLimits turns = poses.turns({50 * std::cos(at), 50 * std::sin(at), 0, 0});
    RC_ASSERT(std::abs(2 * std::atan(0.5f * turns.high) - (low + width - at)) < 1e-5f);
    RC_ASSERT(std::abs(2 * std::atan(0.5f * turns.low) - (low - at)) < 1e-5f);
  }));
}

/// In a range of more than half a turn, only a bound less than a quarter of a turn ahead limits the pose.
TEST(PoseRange, IsNotLimitedByABoundBehindThePose) {
  EXPECT_TRUE(rc::check([] {
    const float low = 0.001f * float(*rc::gen::inRange(-3141, 3141));
    const float width = 0.001f * float(*rc::gen::inRange(3200, 6200));
    const PoseRange poses{1, 200, direction_range(low, low + width)};
    const float to_low = width * 0.01f * float(*rc::gen::inRange(0, 101));
    const float at = low + to_low;
    const TurnLimits turns = poses.turns({50 * std::cos(at), 50 * std::sin(at), 0, 0});
    constexpr float kQuarter = 1.5707963f;
    RC_PRE(std::abs(to_low - kQuarter) > 1e-3f && std::abs(width - to_low - kQuarter) > 1e-3f);
    const auto limited = [&](float ahead) { return ahead < kQuarter ? 2 * std::tan(0.5f * ahead) : TurnLimits{}.high; };
    RC_ASSERT(std::abs(turns.high - limited(width - to_low)) < 1e-4f);
    RC_ASSERT(std::abs(-turns.low - limited(to_low)) < 1e-4f);
  }));
}

/// Refinement with one allowed angle changes only place and size, and finds the hole.
TEST(Refine, KeepsTheOneAllowedAngle) {
  const Shape shape = test::make_library_shape("bean", test::bean_outline());
  CollageSettings s = settings();
  s.pieces.min_rotation_rad = s.pieces.max_rotation_rad = 0;
  const MatchingContext context = make_matching_context(s, 1);
  const ShapeModel model = test::models_of({shape}, context, 0, 1).front();
  const CanvasField hole = hole_of(shape, {70, 0, 128, 128}, 256);
  EXPECT_TRUE(rc::check([&] {
    Similarity pose{71, 0, 128 + float(*rc::gen::inRange(-3, 4)), 128 + float(*rc::gen::inRange(-3, 4))};
    RC_ASSERT(refine(pose, model, FieldView(hole), stance_of(context).poses, context.hard_depth_px));
    RC_ASSERT(pose.b == 0.f);
    RC_ASSERT(norm(pose.translation() - Vec2{128, 128}) < 1.5f);
    grow(pose, model, hole, context);
    RC_ASSERT(pose.b == 0.f);
  }));
}

/// The holes lie slightly beyond a bound of the scale, so the descent presses against that bound. Rounding must not reject the pose.
TEST(Refine, RoundingRejectsNothingAtTheBoundsOfScale) {
  const Shape shape = test::make_library_shape("bean", test::bean_outline());
  for (const float bound_px : {20.f, 20.001f, 33.333f, 47.11f, 90.07f}) {
    for (const bool lower : {true, false}) {
      CollageSettings s = settings();
      s.pieces.min_scale_px = lower ? bound_px : 15;
      s.pieces.max_scale_px = lower ? 120 : bound_px;
      const MatchingContext context = make_matching_context(s, 1);
      const ShapeModel model = test::models_of({shape}, context, 0, 1).front();
      const CanvasField hole = hole_of(shape, {bound_px * (lower ? 0.995f : 1.02f), 0, 128, 128}, 256);
      for (float angle = 0; angle < 0.05f; angle += 0.003f) {
        Similarity pose{bound_px * std::cos(angle), bound_px * std::sin(angle), 128, 128};
        ASSERT_TRUE(refine(pose, model, FieldView(hole), stance_of(context).poses, context.hard_depth_px))
            << bound_px << " turned by " << angle;
        EXPECT_GE(pose.scale(), s.pieces.min_scale_px);
        EXPECT_LE(pose.scale(), s.pieces.max_scale_px);
      }
    }
  }
}

TEST(Levels, NarrowRangesOfScalesKeepTheirPads) {
  for (float min_px = 12; min_px < 200; min_px *= 1.013f) {
    for (const float ratio : {1.001f, 1.05f, 1.1f, 1.3f}) {
      CollageSettings s;
      s.pieces.min_scale_px = min_px;
      s.pieces.max_scale_px = min_px * ratio;
      EXPECT_FALSE(make_matching_context(s, 1).levels.empty()) << min_px << " to " << min_px * ratio << " px";
    }
  }
}

TEST(SelectPairs, FindsThePlaceWhereTheShapeCameFrom) {
  const std::vector<Shape> shapes = test::synthetic_library(6);
  const MatchingContext context = make_matching_context(settings(), 6);
  const ShapeModel model = test::models_of(shapes, context, 4, 5).front();
  // The target is the shape itself at the scale at which level slot 1 agrees.
  const int slot = 1;
  const float scale = 2.5f / kSmoothingLevels[context.levels[slot]].sigma;
  TargetSample sample;
  sample.pyramid = shapes[4].levels[context.levels[slot]].samples[20];
  for (int i = 0; i < 5; ++i) {
    sample.pyramid.left[i] *= scale;
    sample.pyramid.right[i] *= scale;
  }
  const auto pairs = select_pairs(model, sample, context.stances.list(ShapeId{4}), context, context.beta_steps);
  ASSERT_FALSE(pairs.empty());
  EXPECT_LE(pairs.front().distance, kLibraryPadSteps / 2 + 1) << "no farther than a library rounds its PADs";
  EXPECT_EQ(pairs.front().source, model.levels[0].samples.size() + 20);
  EXPECT_LE(pairs.size(), std::size_t(kPairsPerShape));
}

/// Long improvement has many passes, and jobs may draw often. No pass repeats the draws of another pass or sample.
TEST(DrawTangent, DiffersBetweenPassesAndSamples) {
  const MatchingContext context = make_matching_context(settings(), 1000);
  const auto draws = [&](std::uint32_t id, std::uint32_t pass, std::uint32_t first) {
    TargetSample sample;
    sample.id = SampleId{id};
    sample.pass = pass;
    std::vector<std::uint32_t> points;
    for (std::uint32_t i = first; i < first + 50; ++i) {
      const TangentDraw draw = draw_tangent(context, sample, i);
      points.push_back(index_of(draw.shape) * 1000 + (draw.point_bits >> 24));
    }
    return points;
  };
  EXPECT_NE(draws(3, 0, 0), draws(3, 65536, 0));
  EXPECT_NE(draws(3, 0, 65536), draws(3, 1, 0));
  EXPECT_NE(draws(3, 65536, 0), draws(2, 0, 0));
}

TEST(BinLimit, KeepsTheShareAndAtLeastTheFirstPairs) {
  DistanceHistogram h{};
  h[3] = 5;
  h[10] = 7;
  h[20] = 100;
  EXPECT_EQ(bin_limit_for(h, 12), 20u);
  EXPECT_EQ(bin_limit_for(h, 11), 10u);
  EXPECT_EQ(bin_limit_for(h, 1), 4u);  // not even the best bin fits, but it is kept
  EXPECT_EQ(bin_limit_for(h, 1000), std::uint32_t(kDistanceBins));
}

}  // namespace test_docking
}  // namespace tessera
