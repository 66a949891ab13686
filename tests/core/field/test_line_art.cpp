// Shapes made of lines: the depth allowed in them, and the width of the gap that they need.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/collage/placed_outlines.h"
#include "core/collage/wide_gap.h"
#include "core/field/line_art.h"
#include "core/geometry/convex_hull.h"
#include "core/shape/shape_field.h"
#include "support/synthetic_shapes.h"

namespace tessera {
namespace test_line_art {

const Shape& thin_ring() {
  static const Shape shape = test::make_test_shape("ring", test::ring_outline(0.88f));
  return shape;
}

const Shape& bar() {
  static const Shape shape = test::make_test_shape("bar", test::rectangle_outline(9, 0.4f));
  return shape;
}

float radius_of_lines(const Shape& shape) { return line_radius(shape.field, shape.perimeter); }

TEST(LineRadius, IsHalfTheMeanWidthOfTheLines) {
  const float unit = std::sqrt(3.14159265f * (1 - 0.88f * 0.88f));  // in units of the ring's outer radius
  EXPECT_NEAR(radius_of_lines(thin_ring()), 0.06f / unit, 0.001f);
  EXPECT_NEAR(radius_of_lines(bar()), 0.2f / std::sqrt(3.6f), 0.006f) << "its ends count, too";
}

TEST(LineRadius, IsInfiniteWhereAShapeIsMoreThanLines) {
  EXPECT_TRUE(std::isinf(radius_of_lines(test::make_test_shape("ring", test::ring_outline(0.6f)))));
  EXPECT_TRUE(std::isinf(radius_of_lines(test::make_test_shape("star", test::star_outline(5)))));
  EXPECT_TRUE(std::isinf(radius_of_lines(test::make_test_shape("disc", test::disc_outline()))));
}

TEST(MostDepth, IsWhatIsAllowedInGeneralButInLines) {
  EXPECT_EQ(most_depth_px(1.4f, INFINITY), 1.4f);
  EXPECT_EQ(most_depth_px(1.4f, 10), 1.4f);
  EXPECT_FLOAT_EQ(most_depth_px(1.4f, 1.2f), 0.84f);
}

TEST(StoredDepth, ReachesWhatIsAllowedInGeneralWhereALineMayBeEnteredNoDeeper) {
  const StoredDepth in_ordinary_pieces(1.4f, INFINITY);
  for (const float d : {3.f, 0.f, -0.4f, -1.f, -30.f}) EXPECT_EQ(in_ordinary_pieces(d), d);
  const StoredDepth in_lines(1.4f, 1.2f);
  for (const float d : {3.f, 0.f, -0.5f}) EXPECT_EQ(in_lines(d), d) << "areas are counted by it";
  EXPECT_NEAR(in_lines(-0.84f), -1.4f, 1e-5f);
  EXPECT_LT(in_lines(-1.2f), -2.3f);
  const StoredDepth in_hairs(1.4f, 0.3f);
  EXPECT_NEAR(in_hairs(-0.6f), -1.4f, 1e-5f);
}

/// Two rings with lines 2.4 px wide, which cross, or touch from inside or outside.
TEST(LineArt, MayTouchButNotCross) {
  const PieceSettings pieces;
  const float scale_px = 1.2f / radius_of_lines(thin_ring());
  const float outer_px = thin_ring().radius * scale_px;
  const auto at = [&](float x) { return Similarity{scale_px, 0, x, 100}; };
  for (const float apart_px : {2 * outer_px - 0.7f, 2 * outer_px, 2 * outer_px + 5}) {
    FreeField free(make_rectangle_canvas(300, 200), pieces);
    PlacedOutlines outlines(free, pieces);
    free.stamp(thin_ring(), at(100));
    outlines.add({ShapeId{0}, at(100), 1, 1}, thin_ring().outline, radius_of_lines(thin_ring()));
    EXPECT_TRUE(outlines.conflicts(thin_ring(), at(100 + apart_px)).empty()) << apart_px;
    for (const float crossing_px : {2 * outer_px - 2.4f, 2 * outer_px - 8, outer_px, 7.f}) {
      EXPECT_FALSE(outlines.conflicts(thin_ring(), at(100 + crossing_px)).empty()) << crossing_px;
    }
  }
}

TEST(LineArt, IsDeepEnoughInTheFreeFieldToBeSeen) {
  const PieceSettings pieces;
  FreeField free(make_rectangle_canvas(300, 200), pieces);
  free.stamp(bar(), {1.2f / radius_of_lines(bar()), 0, 150, 100.5f});
  float deepest_px = 0;
  for (float y = 98; y < 103; y += 0.25f) deepest_px = std::min(deepest_px, field_value(free.view(), {150, y}));
  EXPECT_LT(deepest_px, -hard_depth_px(pieces));
}

TEST(WideGap, IsAsWideAsTheShapeIsAtItsNarrowestWithAllThatItEncloses) {
  const Shape fork = test::make_test_shape(
      "fork", {{{{0, 0}, {10, 0}, {10, 7}, {8.4f, 7}, {8.4f, 1.6f}, {1.6f, 1.6f}, {1.6f, 7}, {0, 7}}}});
  const float area = 70 - 6.8f * 5.4f;
  const HullRoom room = hull_room(fork);
  EXPECT_NEAR(room.radius, 3.5f / std::sqrt(area), 0.02f);
  EXPECT_NEAR(room.area, 70 / area, 0.02f);
  const Box box = bounding_box(fork.outline);
  EXPECT_LT(norm(room.middle - (box.low + box.high) * 0.5f), 0.02f);
}

/// Other pieces may lie in the area that the lines enclose.
TEST(WideGap, IsOneOfItsAreaWhereAShapeConsistsOfLines) {
  EXPECT_EQ(hull_room(thin_ring()).radius, kLeastWideGap);
  EXPECT_TRUE(hull_room(thin_ring()).hardly_docks());
  EXPECT_TRUE(hull_room(bar()).hardly_docks());
  EXPECT_FALSE(hull_room(test::make_test_shape("star", test::star_outline(5))).hardly_docks());
}

TEST(WideGap, TheWidestOnesRadiusIsFoundInTheWindow) {
  const PieceSettings pieces;
  FreeField free(make_rectangle_canvas(120, 80), pieces);
  const Window all = free.field().value.bounds();
  EXPECT_NEAR(widest_gap_px(free, all), 40, 0.6f);
  const int margin = int(-free.field().origin.x);
  EXPECT_NEAR(widest_gap_px(free, {margin, margin, margin + 11, margin + 80}), 10, 0.6f) << "round a node within";
  free.stamp(test::make_test_shape("disc", test::disc_outline()), {60, 0, 60, 40});
  EXPECT_LT(widest_gap_px(free, all), 20);
  EXPECT_EQ(widest_gap_px(free, {margin - 3, margin - 3, margin, margin}), 0) << "outside";
}

/// The hole is hardly wider and longer than the shape, and the shape stands in it at an angle.
TEST(WideGap, APoseIsFoundWhereOneFits) {
  const PieceSettings pieces;
  const Shape shape = test::make_test_shape("spectacles", test::spectacles_outline(0.2f));
  const ShapeModel model = make_shape_model(shape, PadParameters{}, PadParameters{}, {});
  HullRoom room = hull_room(shape);
  room.radius = 0.5f * float(least_width(convex_hull(shape.outline.curves.front())));
  const Vec2 askew{std::cos(0.42f), std::sin(0.42f)};
  const auto found_in = [&](float hole_px, const PoseRange& poses) {
    FreeField free(make_rectangle_canvas(200, 200), pieces);
    const float scale_px = hole_px / room.radius;  // the hull of the spectacles, with a frame around it
    const Outline hull = {{convex_hull(shape.outline.curves.front())}};
    std::vector<Vec2> inside = hull.curves.front();
    std::reverse(inside.begin(), inside.end());
    for (Vec2& p : inside) p = Vec2{p.x * askew.x - p.y * askew.y, p.x * askew.y + p.y * askew.x} * (scale_px / 300);
    const Outline outline = {{{{-0.5f, -0.5f}, {0.5f, -0.5f}, {0.5f, 0.5f}, {-0.5f, 0.5f}}, inside}};
    const Shape frame = test::make_test_shape("frame", outline);
    free.stamp(frame, {300 * std::sqrt(float(test::shoelace_area(outline))), 0, 100, 100});
    std::vector<Similarity> found;
    any_pose_in_gap(
        model, room, poses, free, free.field().value.bounds(), [] {},
        [&](const Similarity& pose) {
          found.push_back(pose);
          return true;
        });
    return found;
  };
  const PoseRange any{20, 60, direction_range(-4, 4)};
  const std::vector<Similarity> found = found_in(20 * room.radius + 1.5f, any);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].scale(), 20, 0.001f);
  EXPECT_GT(std::abs(dot(Vec2{found[0].a, found[0].b}, askew)), 20 * std::cos(0.1f)) << "or upside down";
  EXPECT_TRUE(found_in(20 * room.radius - 2, any).empty());
  EXPECT_TRUE(found_in(20 * room.radius + 1.5f, {20, 60, direction_range(-0.1f, 0.1f)}).empty());
  EXPECT_EQ(found_in(20 * room.radius + 1.5f, {20, 60, direction_range(0.41f, 0.43f)}).size(), 1u) << "a narrow range";
}

/// A search that finds nothing can be stopped, too.
TEST(WideGap, ASearchCanBeStopped) {
  const PieceSettings pieces;
  const Shape shape = test::make_test_shape("spectacles", test::spectacles_outline(0.2f));
  const ShapeModel model = make_shape_model(shape, PadParameters{}, PadParameters{}, {});
  FreeField free(make_rectangle_canvas(300, 200), pieces);
  int checks = 0;
  const auto count = [&] { ++checks; };
  const auto refuse = [](const Similarity&) { return false; };
  any_pose_in_gap(model, hull_room(shape), {20, 60, direction_range(-4, 4)}, free, free.field().value.bounds(), count,
                  refuse);
  EXPECT_GE(checks, 5);
}

}  // namespace test_line_art
}  // namespace tessera
