// Mirrored and stretched shapes are valid library shapes.
#include "bench/inputs/shape_variation.h"

#include <gtest/gtest.h>

#include "core/geometry/polygon.h"
#include "support/matching_scene.h"

namespace tessera {
namespace test_shape_variation {

Shape shape_of(const Outline& outline) { return test::shape_from_outline(outline, {}); }

AreaMoment moment_of(const Outline& outline) {
  AreaMoment sum;
  for (const auto& curve : outline.curves) sum += area_moment(curve);
  return sum;
}

TEST(ShapeVariation, IsAValidShape) {
  for (const Outline& outline : {test::ring_outline(), test::bean_outline(), test::blob_outline(7)}) {
    for (const ShapeVariation& variation : {ShapeVariation{true, 0, 1}, {false, 0.4f, 1.5f}, {true, 2.f, 1.3f}}) {
      const Shape shape = varied_shape(shape_of(outline), variation, {});
      const AreaMoment moment = moment_of(shape.outline);
      EXPECT_NEAR(moment.area, 1, 1e-4);
      EXPECT_NEAR(moment.x, 0, 1e-4);
      EXPECT_NEAR(moment.y, 0, 1e-4);
      EXPECT_GT(signed_area(shape.outline.curves[0]), 0) << "interior on the left";
      for (std::size_t c = 1; c < shape.outline.curves.size(); ++c) {
        EXPECT_LT(signed_area(shape.outline.curves[c]), 0) << "a hole";
      }
      for (std::size_t k = 0; k < kSmoothingLevels.size(); ++k) {
        EXPECT_EQ(shape.levels[k].samples.size(), std::size_t(kSmoothingLevels[k].samples));
        EXPECT_GT(signed_area(shape.levels[k].points), 0);
      }
    }
  }
}

TEST(ShapeVariation, MirrorsTheField) {
  const Shape shape = shape_of(test::blob_outline(3));
  const Shape mirrored = varied_shape(shape, {true, 0, 1}, {});
  for (const Vec2 p : {Vec2{0.2f, 0.1f}, {0.5f, -0.4f}, {-0.3f, 0.6f}}) {
    EXPECT_NEAR(mirrored.field.at({-p.x, p.y}), shape.field.at(p), 5e-3f);
  }
}

TEST(ShapeVariation, StretchesAlongItsDirection) {
  const Shape disc = shape_of(test::disc_outline());
  const Shape ellipse = varied_shape(disc, {false, 0, 1.5f}, {});
  const Box box = bounding_box(ellipse.outline.curves[0]);
  EXPECT_NEAR(box.width() / box.height(), 1.5f * 1.5f, 0.01f);
}

}  // namespace test_shape_variation
}  // namespace tessera
