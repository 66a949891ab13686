// The distance field of a shape against brute force.
#include "core/shape/shape_field.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "support/synthetic_shapes.h"

namespace tessera {
namespace test_shape_field {

/// Scales an outline to about the size of a library shape, with as many points.
Outline shape_frame(Outline outline) {
  for (std::vector<Vec2>& curve : outline.curves) {
    curve = test::resampled(curve, 512);
    for (Vec2& p : curve) p = p * 0.6f;
  }
  return outline;
}

Outline any_outline() {
  const int kind = *rc::gen::inRange(0, 3);
  if (kind == 0) return shape_frame(test::star_outline(*rc::gen::inRange(3, 9), 0.3f));
  if (kind == 1) return shape_frame(test::ring_outline(0.1f * float(*rc::gen::inRange(2, 9))));
  return shape_frame(test::blob_outline(*rc::gen::inRange<std::uint32_t>(1, 1u << 30)));
}

Vec2 node(const ShapeField& field, int i, int j) {
  const auto at = [&](int k) { return field.extent * (2 * float(k) / (kShapeFieldNodes - 1) - 1); };
  return {at(i), at(j)};
}

TEST(ShapeField, NodesEqualBruteForce) {
  EXPECT_TRUE(rc::check([] {
    const Outline outline = any_outline();
    const ShapeField field = make_shape_field(outline);
    const int stride = *rc::gen::inRange(5, 11);
    for (int j = 0; j < kShapeFieldNodes; j += stride) {
      for (int i = 0; i < kShapeFieldNodes; i += stride) {
        RC_ASSERT(std::abs(field.distance(i, j) - test::signed_distance(outline, node(field, i, j))) < 1e-5f);
      }
    }
  }));
}

TEST(ShapeField, HasARim) {
  const Outline outline = shape_frame(test::star_outline(5));
  const ShapeField field = make_shape_field(outline);
  EXPECT_EQ(field.distance.width(), kShapeFieldNodes);
  EXPECT_EQ(field.distance.height(), kShapeFieldNodes);
  for (int k = 0; k < kShapeFieldNodes; ++k) {
    for (const float d : {field.distance(k, 0), field.distance(0, k), field.distance(k, kShapeFieldNodes - 1)}) {
      EXPECT_GE(d, kShapeFieldRim - 1e-5f);
    }
  }
}

TEST(ShapeField, InterpolatesBetweenNodes) {
  EXPECT_TRUE(rc::check([] {
    const Outline outline = any_outline();
    const ShapeField field = make_shape_field(outline);
    const float spacing = 2 * field.extent / (kShapeFieldNodes - 1);
    const auto coordinate = [&] { return field.extent * float(*rc::gen::inRange(-1000, 1001)) / 1000; };
    const Vec2 p{coordinate(), coordinate()};
    RC_ASSERT(std::abs(field.at(p) - test::signed_distance(outline, p)) < spacing);
  }));
}

TEST(ShapeField, NodesAreReproduced) {
  const ShapeField field = make_shape_field(shape_frame(test::bean_outline()));
  for (const int k : {0, 1, 63, 64, 126, 127}) EXPECT_NEAR(field.at(node(field, k, 40)), field.distance(k, 40), 1e-4f);
}

TEST(ShapeField, IsALowerBoundBeyondTheGrid) {
  const ShapeField field = make_shape_field(shape_frame(test::disc_outline()));
  const float e = field.extent;
  for (const Vec2 p : {Vec2{e + 2, 0}, Vec2{-e - 3, -e - 4}, Vec2{e + 0.01f, 0.9f * e}}) {
    EXPECT_LE(field.at(p), norm(p) - 0.6f + 1e-3f);
    EXPECT_GE(field.at(p), 0.7f * (norm(p) - 0.6f));
  }
}

}  // namespace test_shape_field
}  // namespace tessera
