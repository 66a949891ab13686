// Distances between polygons against brute force, bounds of distances against true ones, and boxes.
#include "core/geometry/polygon_index.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "core/field/piece_distance.h"
#include "support/polygon_distance.h"
#include "support/synthetic_shapes.h"

namespace tessera {
namespace test_polygon_index {

Outline any_outline() {
  const int kind = *rc::gen::inRange(0, 4);
  if (kind == 0) return test::star_outline(*rc::gen::inRange(3, 9), 0.2f);
  if (kind == 1) return test::ring_outline(0.1f * float(*rc::gen::inRange(2, 9)));
  if (kind == 2) return test::rectangle_outline(0.05f, 2);
  Outline blob = test::blob_outline(*rc::gen::inRange<std::uint32_t>(1, 1u << 30));
  blob.curves[0] = test::resampled(blob.curves[0], *rc::gen::inRange(3, 200));
  return blob;
}

Outline placed(Outline outline) {
  const float scale = 0.5f * float(*rc::gen::inRange(4, 120));
  const float angle = 0.01f * float(*rc::gen::inRange(0, 628));
  const Similarity pose{scale * std::cos(angle), scale * std::sin(angle), 0.37f * float(*rc::gen::inRange(-200, 200)),
                        0.37f * float(*rc::gen::inRange(-200, 200))};
  for (std::vector<Vec2>& curve : outline.curves) {
    for (Vec2& p : curve) p = pose.apply(p);
  }
  return outline;
}

/// The first part of a piece in several parts is only one of them.
TEST(BoundingBox, OfAnOutlineHoldsAllCurves) {
  const Outline parts{{{{0, 0}, {2, 0}, {2, 1}}, {{5, -3}, {6, -3}, {6, -2}}, {{-1, 4}, {1, 4}, {1, 7}}}};
  const Box box = bounding_box(parts);
  EXPECT_EQ(box.low, (Vec2{-1, -3}));
  EXPECT_EQ(box.high, (Vec2{6, 7}));
}

TEST(BoundingBox, UnitedHoldsBothWhicheverComesFirst) {
  const Box left{{0, 2}, {3, 4}}, right{{1, -1}, {8, 3}};
  for (const Box& box : {united(left, right), united(right, left)}) {
    EXPECT_EQ(box.low, (Vec2{0, -1}));
    EXPECT_EQ(box.high, (Vec2{8, 4}));
  }
}

TEST(PolygonIndex, ApproachesAsNearAsBruteForce) {
  EXPECT_TRUE(rc::check([] {
    const Outline a = placed(any_outline());
    const Outline b = placed(any_outline());
    const PolygonIndex index(b);
    const float reach = 0.5f * float(*rc::gen::inRange(1, 200));
    float least = reach;
    for (const std::vector<Vec2>& curve : a.curves) {
      for (std::size_t i = 0, j = curve.size() - 1; i < curve.size(); j = i++) {
        const Approach found = index.approach(Segment{curve[j], curve[i]}, reach);
        least = std::min(least, found.distance);
        if (found.distance < reach && found.distance > 0) {
          RC_ASSERT(std::abs(norm(found.here - found.there) - found.distance) < 1e-4f);
        }
      }
    }
    const double truth = std::min(double(reach), test::boundary_distance(a, b));
    RC_ASSERT(std::abs(double(least) - truth) < 1e-3);
  }));
}

TEST(PolygonIndex, IsNearerThanAReachWhereItsApproachIs) {
  EXPECT_TRUE(rc::check([] {
    const PolygonIndex index(placed(any_outline()));
    const Box box = index.box();
    for (int k = 0; k < 50; ++k) {
      const Vec2 p{box.low.x + box.width() * 0.001f * float(*rc::gen::inRange(-300, 1300)),
                   box.low.y + box.height() * 0.001f * float(*rc::gen::inRange(-300, 1300))};
      const float reach = 0.1f * float(*rc::gen::inRange(1, 200));
      RC_ASSERT(index.nearer_than(reach, p) == (index.approach(p, reach).distance < reach));
    }
  }));
}

TEST(PolygonIndex, ContainsByTheEvenOddRule) {
  EXPECT_TRUE(rc::check([] {
    const Outline outline = placed(any_outline());
    const PolygonIndex index(outline);
    const Box box = index.box();
    for (int k = 0; k < 50; ++k) {
      const Vec2 p{box.low.x + box.width() * 0.001f * float(*rc::gen::inRange(-100, 1100)),
                   box.low.y + box.height() * 0.001f * float(*rc::gen::inRange(-100, 1100))};
      if (std::abs(test::signed_distance(outline, p)) < 1e-3f) continue;
      RC_ASSERT(index.contains(p) == (test::signed_distance(outline, p) < 0));
    }
  }));
}

/// Beyond a shape's own grid its distance may be too small, but never too large.
TEST(PieceDistance, IsALowerBoundBeyondTheGrid) {
  EXPECT_TRUE(rc::check([] {
    const Shape shape = test::make_test_shape("any", any_outline());
    const float scale = 40;
    const PieceDistance piece(shape, {scale, 0, 100, 100}, 0);
    const float cell_px = scale * 2 * shape.field.extent / float(shape.field.distance.width() - 1);
    for (int k = 0; k < 30; ++k) {
      const Vec2 p{float(*rc::gen::inRange(-100, 300)), float(*rc::gen::inRange(-100, 300))};
      const Vec2 in_shape = (p - Vec2{100, 100}) * (1 / scale);
      if (std::max(std::abs(in_shape.x), std::abs(in_shape.y)) <= shape.field.extent) continue;
      const float truth = scale * test::signed_distance(shape.outline, in_shape);
      const float found = piece.at(p);
      RC_ASSERT(found <= truth + 0.1f * cell_px);
      RC_ASSERT(found >= 0.5f * truth);
    }
  }));
}

}  // namespace test_polygon_index
}  // namespace tessera
