// Pieces with given poses: which lie outside, in a zone, or on each other.
#include "core/collage/standing_check.h"

#include <gtest/gtest.h>

#include "core/field/keep_out.h"
#include "support/synthetic_shapes.h"

namespace tessera {
namespace test_standing_check {

const Shape& square() {
  static const Shape shape = test::make_test_shape("square", test::rectangle_outline(1, 1));
  return shape;
}

GivenPiece piece(float scale_px, Vec2 at_px) { return {ShapeId{0}, {scale_px, 0, at_px.x, at_px.y}}; }

GivenPieceCheck check(const Canvas& canvas, const std::vector<GivenPiece>& pieces, float overlap_px = 0) {
  return check_given_pieces(canvas, pieces, overlap_px, [](ShapeId) -> const Shape& { return square(); });
}

using Places = std::vector<std::size_t>;

TEST(GivenPieceCheck, PiecesThatLieWellAreNotTold) {
  const GivenPieceCheck found = check(make_rectangle_canvas(200, 100), {piece(40, {20, 50}), piece(40, {60, 50})});
  EXPECT_EQ(found.outside, Places{});
  EXPECT_EQ(found.kept_out, Places{});
  EXPECT_EQ(found.overlapping, Places{});
}

TEST(GivenPieceCheck, TellsWhatLiesOutsideAndOnOthers) {
  const GivenPieceCheck found = check(
      make_rectangle_canvas(200, 100),
      {piece(40, {100, 50}), piece(40, {4, 50}), piece(40, {120, 50}), piece(40, {900, 50}), piece(40, {138, 50})});
  EXPECT_EQ(found.outside, (Places{1, 3}));
  EXPECT_EQ(found.overlapping, (Places{2, 4})) << "the later one is told";
}

TEST(GivenPieceCheck, AlittleBesideTheEdgeOrOnOthersIsAsPiecesLie) {
  const GivenPieceCheck found = check(make_rectangle_canvas(200, 100), {piece(40, {19, 50}), piece(40, {58, 50})});
  EXPECT_EQ(found.outside, Places{});
  EXPECT_EQ(found.overlapping, Places{});
}

/// For a small piece the allowed overlap is more than a twentieth: 2 of 20 px.
TEST(GivenPieceCheck, TheOverlapThatTheJobAllowsIsNotTold) {
  const Canvas canvas = make_rectangle_canvas(200, 100);
  const std::vector<GivenPiece> pieces = {piece(20, {8, 50}), piece(20, {26, 50}), piece(20, {-4, 20})};
  EXPECT_EQ(check(canvas, pieces).outside, (Places{0, 2}));
  EXPECT_EQ(check(canvas, pieces, 2).outside, Places{2});
  EXPECT_EQ(check(canvas, pieces).overlapping, Places{1});
  EXPECT_EQ(check(canvas, pieces, 2).overlapping, Places{});
}

TEST(GivenPieceCheck, AZoneIsNoOutside) {
  Canvas canvas = make_rectangle_canvas(200, 100);
  take_out(distance_to({KeepOutRectangle{{100, 50}, {30, 30}}}, canvas), canvas);
  const GivenPieceCheck found = check(canvas, {piece(40, {30, 50}), piece(40, {80, 50}), piece(40, {100, 50})});
  EXPECT_EQ(found.kept_out, (Places{1, 2}));
  EXPECT_EQ(found.outside, Places{});
}

TEST(GivenPieceCheck, AcrossASeamNothingIsOutside) {
  const GivenPieceCheck found =
      check(make_seamless_canvas(200, 100, true, false), {piece(40, {0, 50}), piece(40, {190, 50})});
  EXPECT_EQ(found.outside, Places{});
  EXPECT_EQ(found.overlapping, Places{1});
}

}  // namespace test_standing_check
}  // namespace tessera
