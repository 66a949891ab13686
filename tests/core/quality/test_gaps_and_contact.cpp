// Discs in the gaps of a collage, and the distances along the boundaries of its pieces.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/quality/cell_counts.h"
#include "core/quality/gap_field.h"
#include "core/quality/shared_boundary.h"

namespace tessera {
namespace test_gaps_and_contact {

JudgedPiece box(float x0, float y0, float x1, float y1) {
  JudgedPiece piece;
  piece.outline_px.curves = {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
  piece.centre_px = {(x0 + x1) / 2, (y0 + y1) / 2};
  piece.scale_px = std::sqrt((x1 - x0) * (y1 - y0));
  return piece;
}

std::vector<GapDisc> discs_of(const Canvas& canvas, const std::vector<JudgedPiece>& pieces, float least_px,
                              std::size_t most = 1000) {
  return gap_discs(gap_field(count_cells(canvas, pieces), canvas.period), least_px, most);
}

TEST(GapDiscs, find_the_two_holes_of_a_covered_canvas) {
  // all of 100 x 60 px is covered but a square of 20 px and one of 10 px
  const std::vector<JudgedPiece> pieces = {box(0, 0, 100, 20),  box(0, 40, 100, 60),  box(0, 20, 10, 40),
                                           box(30, 20, 60, 40), box(70, 20, 100, 40), box(60, 20, 70, 25),
                                           box(60, 35, 70, 40)};
  const std::vector<GapDisc> discs = discs_of(make_rectangle_canvas(100, 60), pieces, 4);
  ASSERT_EQ(discs.size(), 2u);
  EXPECT_NEAR(discs[0].centre_px.x, 20, 0.6);
  EXPECT_NEAR(discs[0].centre_px.y, 30, 0.6);
  EXPECT_NEAR(discs[0].radius_px, 10, 0.6);
  EXPECT_NEAR(discs[1].centre_px.x, 65, 0.6);
  EXPECT_NEAR(discs[1].radius_px, 5, 0.6);
  EXPECT_EQ(discs_of(make_rectangle_canvas(100, 60), pieces, 4, 1).size(), 1u);
  EXPECT_EQ(discs_of(make_rectangle_canvas(100, 60), pieces, 7).size(), 1u);
}

TEST(GapDiscs, a_seamless_canvas_has_a_gap_across_its_edge_once) {
  const Canvas canvas = make_seamless_canvas(80, 40, true, true);
  const std::vector<JudgedPiece> pieces = {box(10, 0, 70, 40),
                                           box(-10, 30, 10, 50)};  // free: x from 70 to 90, y from 10 to 30
  const std::vector<GapDisc> discs = discs_of(canvas, pieces, 6);
  ASSERT_EQ(discs.size(), 1u);
  EXPECT_NEAR(discs[0].radius_px, 10, 0.6);
  EXPECT_NEAR(discs[0].centre_px.y, 20, 0.6);
  EXPECT_NEAR(canvas.period.nearest(discs[0].centre_px, {80, 20}).x, 80, 0.6);
}

RC_GTEST_PROP(GapDiscs, do_not_overlap_and_lie_in_the_free_area, ()) {
  std::vector<JudgedPiece> pieces;
  for (int k = *rc::gen::inRange(0, 8); k > 0; --k) {
    const float x = float(*rc::gen::inRange(0, 90)), y = float(*rc::gen::inRange(0, 60));
    pieces.push_back(box(x, y, x + float(*rc::gen::inRange(3, 40)), y + float(*rc::gen::inRange(3, 40))));
  }
  const std::vector<GapDisc> discs = discs_of(make_rectangle_canvas(100, 70), pieces, 2);
  for (std::size_t k = 0; k < discs.size(); ++k) {
    const GapDisc& disc = discs[k];
    for (std::size_t other = 0; other < k; ++other) {
      RC_ASSERT(norm(disc.centre_px - discs[other].centre_px) >= disc.radius_px + discs[other].radius_px);
      RC_ASSERT(discs[other].radius_px >= disc.radius_px);
    }
    RC_ASSERT(disc.centre_px.x - disc.radius_px > -0.6f && disc.centre_px.x + disc.radius_px < 100.6f);
    for (const JudgedPiece& piece : pieces) {
      const std::vector<Vec2>& c = piece.outline_px.curves[0];
      const Vec2 nearest{std::clamp(disc.centre_px.x, c[0].x, c[2].x), std::clamp(disc.centre_px.y, c[0].y, c[2].y)};
      RC_ASSERT(norm(disc.centre_px - nearest) > disc.radius_px - 0.6f);
    }
  }
}

TEST(BoundaryDistances, go_to_the_nearest_other_piece_or_the_edge) {
  const std::vector<JudgedPiece> pieces = {box(1, 10, 21, 30), box(24, 10, 40, 30)};
  const std::vector<float> px = boundary_distances_px(make_rectangle_canvas(100, 60), pieces, 5);
  ASSERT_EQ(px.size(), 8u);
  EXPECT_NEAR(px[0], 1, 0.05) << "the canvas' left edge";
  EXPECT_NEAR(px[1], 3, 0.1) << "the other piece; its own sides do not count";
  EXPECT_NEAR(px[4], 3, 0.1);
  EXPECT_FLOAT_EQ(px[5], 5) << "nothing within reach";
}

TEST(BoundaryDistances, cross_a_seam) {
  const std::vector<JudgedPiece> pieces = {box(2, 10, 20, 30), box(60, 10, 79, 30)};
  const std::vector<float> px = boundary_distances_px(make_seamless_canvas(80, 40, true, true), pieces, 5);
  EXPECT_NEAR(px[0], 3, 0.1) << "2 px to the seam and 1 px beyond it";
  EXPECT_FLOAT_EQ(px[1], 5);
  EXPECT_NEAR(px[5], 3, 0.1);
}

}  // namespace test_gaps_and_contact
}  // namespace tessera
