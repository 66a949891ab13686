#include "core/matching/docking.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "core/geometry/closed_curve.h"
#include "core/base/portable_math.h"
#include "core/field/free_field.h"
#include "core/matching/matcher.h"
#include "core/matching/pair_selection.h"
#include "core/matching/refinement.h"
#include "support/random_curves.h"
#include "support/synthetic_library.h"

namespace tessera {
namespace {

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

/// A free region that is exactly the hole a piece leaves.
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

TEST(AlignPyramids, RecoversTheSimilarity) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<Vec2> curve =
        gaussian_smoothed(test::random_curve(*rc::gen::inRange<std::uint32_t>(1, 1u << 30), 1024), 0.05f);
    const ArclengthPyramid shape = sample_pyramids(curve, 0.05f, 16, PadParameters{})[*rc::gen::inRange(0, 16)];
    const Similarity truth = random_similarity(20, 120);
    ArclengthPyramid target = shape;
    for (Vec2& p : target.keypoint) p = truth.apply(p);
    const Alignment found = align_pyramids(shape.keypoint, target, 5, {19, 121});
    RC_ASSERT(found.valid);
    RC_ASSERT(std::abs(found.canvas_from_shape.a - truth.a) < 0.01f);
    RC_ASSERT(std::abs(found.canvas_from_shape.b - truth.b) < 0.01f);
    RC_ASSERT(norm(found.canvas_from_shape.translation() - truth.translation()) < 0.05f);
    RC_ASSERT(!align_pyramids(shape.keypoint, target, 5, {truth.scale() * 1.01f, 500}).valid);
  }));
}

TEST(TangentDocking, AlignsTheFrames) {
  const std::vector<Shape> shapes = test::synthetic_library(4);
  const MatchingContext context = make_matching_context(settings(), 4);
  const auto models = test::models_of(shapes, context, 0, 4);
  TargetSample sample;
  sample.edge = 77;
  sample.position = {200, 100};
  sample.tangent = {0.6f, 0.8f};
  std::array<int, 4> drawn{};
  for (std::uint32_t i = 0; i < 400; ++i) {
    const TangentDraw draw = draw_tangent(context, sample, i);
    ASSERT_LT(draw.shape, 4u);
    ASSERT_GE(draw.scale_px, 20.f);
    ASSERT_LE(draw.scale_px, 120.001f);
    ++drawn[draw.shape];
    const ShapeModel& model = models[draw.shape];
    const Similarity pose = tangent_docking(model, draw, sample);
    EXPECT_LT(norm(pose.apply(model.boundary[draw.boundary_point]) - sample.position), 0.01f);
    const Vec2 direction = pose.apply_direction(model.tangent[draw.boundary_point]) * (1 / draw.scale_px);
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
    RC_ASSERT(refine(pose, model, FieldView(hole), context));
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
  const CanvasField hole = hole_of(shape, {10, 0, 64, 64}, 128);  // smaller than the smallest piece
  Similarity pose{20, 0, 64, 64};
  EXPECT_FALSE(refine(pose, model, FieldView(hole), context));
}

TEST(Grow, StopsAtTheNeighbours) {
  const Shape shape = test::make_library_shape("bean", test::bean_outline());
  const MatchingContext context = make_matching_context(settings(), 1);
  const ShapeModel model = test::models_of({shape}, context, 0, 1).front();
  const CanvasField hole = hole_of(shape, {70, 0, 128, 128}, 256);
  Similarity pose{62, 0, 128, 128};
  grow(pose, model, FieldView(hole), context);
  EXPECT_GT(pose.scale(), 67.f);
  EXPECT_LE(depth_px(pose, model, FieldView(hole)), 0.8f);
}

TEST(Rotation, IsLimitedToItsRange) {
  CollageSettings s = settings();
  s.pieces.min_rotation_rad = -0.5f;
  s.pieces.max_rotation_rad = 0.2f;
  const MatchingContext context = make_matching_context(s, 1);
  const auto turned = [](float rad) { return Similarity{30 * std::cos(rad), 30 * std::sin(rad), 0, 0}; };
  EXPECT_TRUE(context.rotation_allowed(turned(-0.49f)));
  EXPECT_TRUE(context.rotation_allowed(turned(0.19f)));
  EXPECT_FALSE(context.rotation_allowed(turned(-0.51f)));
  EXPECT_FALSE(context.rotation_allowed(turned(0.21f)));
  EXPECT_FALSE(context.rotation_allowed(turned(3.f)));
}

TEST(SelectPairs, FindsThePlaceWhereTheShapeCameFrom) {
  const std::vector<Shape> shapes = test::synthetic_library(6);
  const MatchingContext context = make_matching_context(settings(), 6);
  const ShapeModel model = test::models_of(shapes, context, 4, 5).front();
  // A target that is the shape itself at the scale where level slot 1 agrees.
  const int slot = 1;
  const float scale = 2.5f / kSmoothingLevels[context.levels[slot]].sigma;
  TargetSample sample;
  sample.pyramid = shapes[4].levels[context.levels[slot]].samples[20];
  for (int i = 0; i < 5; ++i) {
    sample.pyramid.left[i] *= scale;
    sample.pyramid.right[i] *= scale;
  }
  const auto pairs = select_pairs(model, sample, context, context.beta_steps);
  ASSERT_FALSE(pairs.empty());
  EXPECT_LE(pairs.front().distance, 1u);
  EXPECT_EQ(pairs.front().source, model.levels[0].samples.size() + 20);
  EXPECT_LE(pairs.size(), std::size_t(kPairsPerShape));
}

/// Long improvement counts many passes, and jobs may draw often: no pass repeats another's draws, nor another sample's.
TEST(DrawTangent, DiffersBetweenPassesAndSamples) {
  const MatchingContext context = make_matching_context(settings(), 1000);
  const auto draws = [&](std::uint32_t edge, std::uint32_t pass, std::uint32_t first) {
    TargetSample sample;
    sample.edge = edge;
    sample.pass = pass;
    std::vector<std::uint32_t> points;
    for (std::uint32_t i = first; i < first + 50; ++i) {
      const TangentDraw draw = draw_tangent(context, sample, i);
      points.push_back(draw.shape * 1000 + draw.boundary_point);
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
  EXPECT_EQ(bin_limit_for(h, 1), 4u);  // not even the best bin fits: it is kept all the same
  EXPECT_EQ(bin_limit_for(h, 1000), std::uint32_t(kDistanceBins));
}

}  // namespace
}  // namespace tessera
