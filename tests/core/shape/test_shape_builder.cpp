// A traced outline, converted to the shape frame.
#include "core/shape/shape_builder.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/base/processor_time.h"
#include "core/geometry/closed_curve.h"
#include "core/geometry/polygon.h"
#include "core/shape/shape_model.h"
#include "support/synthetic_shapes.h"

namespace tessera {
namespace test_shape_builder {

/// A traced outline in an artwork of a few hundred px.
TracedOutline traced(const Outline& outline, float scale_px = 100, Vec2 centre_px = {200, 300}) {
  TracedOutline result;
  for (std::vector<Vec2> curve : outline.curves) {
    for (Vec2& p : curve) p = p * scale_px + centre_px;
    result.curves.push_back(smoothing_spline(curve, 1));
  }
  return result;
}

AreaMoment moment_of(const Outline& outline) {
  AreaMoment sum;
  for (const auto& curve : outline.curves) sum += area_moment(curve);
  return sum;
}

TEST(ShapeBuilder, AreaIsOneAndCentroidIsTheOrigin) {
  for (const Outline& outline :
       {test::ring_outline(), test::bean_outline(), test::star_outline(5), test::blob_outline(7)}) {
    const AreaMoment moment = moment_of(make_shape(traced(outline), {}).outline);
    EXPECT_NEAR(moment.area, 1, 1e-5);
    EXPECT_NEAR(moment.x, 0, 1e-5);
    EXPECT_NEAR(moment.y, 0, 1e-5);
  }
}

TEST(ShapeBuilder, MeasuresOfADisc) {
  const Shape shape = make_shape(traced(test::disc_outline()), {});
  const float radius = 1 / std::sqrt(std::numbers::pi_v<float>);
  EXPECT_NEAR(shape.radius, radius, 1e-3f);
  EXPECT_NEAR(shape.perimeter, 2 * std::numbers::pi_v<float> * radius, 1e-3f);
  EXPECT_NEAR(shape.field.at({0, 0}), -radius, 0.02f);
  EXPECT_LE(shape.field.at({1, 0}), 1 - radius) << "outside the grid a lower bound";
  EXPECT_GE(shape.field.at({1, 0}), 0.75f * (1 - radius));
  EXPECT_NEAR(shape.artwork.centroid_px.x, 200, 0.01f);
  EXPECT_NEAR(shape.artwork.centroid_px.y, 300, 0.01f);
  EXPECT_NEAR(shape.artwork.unit_px, 100 / radius, 0.05f);
}

TEST(ShapeBuilder, PointsOfCurves) {
  Outline outline = test::ring_outline(0.25f);
  const Shape shape = make_shape(traced(outline), {});
  ASSERT_EQ(shape.outline.curves.size(), 2u);
  EXPECT_EQ(shape.outline.curves[0].size(), 512u);
  EXPECT_EQ(shape.outline.curves[1].size(), 128u);
  EXPECT_NEAR(shape.perimeter, closed_length(shape.outline.curves[0]) * 1.25f, 1e-2f);
  EXPECT_EQ(make_shape(traced(test::ring_outline(0.02f)), {}).outline.curves[1].size(), 16u);
}

/// A damaged library may hold any radius: it may cause neither a hang nor an endless number of points.
TEST(ShapeModel, ADamagedRadiusCostsNoTime) {
  Shape shape = test::make_test_shape("bean", test::bean_outline());
  const std::vector<Vec2> interior = make_shape_model(shape, {}, {}, {2}).interior;
  EXPECT_GT(interior.size(), 20u);
  EXPECT_LE(interior.size(), std::size_t(kMaxInteriorPoints));
  shape.radius = 1e4f;
  shape.field.extent = 1e4f;  // makes everything near the middle inside
  const double start_s = processor_time_s();
  make_shape_model(shape, {}, {}, {2});
  EXPECT_LT(processor_time_s() - start_s, 1.0);
}

TEST(ShapeBuilder, LevelsFollowTheirTable) {
  const Shape shape = make_shape(traced(test::bean_outline()), {});
  for (std::size_t k = 0; k < kSmoothingLevels.size(); ++k) {
    EXPECT_EQ(shape.levels[k].points.size(), std::size_t(kSmoothingLevels[k].curve_points));
    EXPECT_EQ(shape.levels[k].samples.size(), std::size_t(kSmoothingLevels[k].samples));
  }
  EXPECT_NEAR(shape.levels.back().perimeter, shape.perimeter, 0.02f);
}

TEST(ShapeBuilder, SizeAndPlaceInTheArtworkDoNotMatter) {
  const Shape small = make_shape(traced(test::blob_outline(3), 60, {100, 100}), {});
  const Shape large = make_shape(traced(test::blob_outline(3), 240, {700, 300}), {});
  for (std::size_t i = 0; i < 512; ++i) {
    EXPECT_LT(norm(small.outline.curves[0][i] - large.outline.curves[0][i]), 0.01f);
  }
}

}  // namespace test_shape_builder
}  // namespace tessera
