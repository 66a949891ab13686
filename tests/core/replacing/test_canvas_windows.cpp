// Windows of replacement trials that are cut out of a canvas with pieces.
#include "core/replacing/canvas_windows.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "core/base/stop.h"
#include "support/synthetic_library.h"

namespace tessera {
namespace test_canvas_windows {

constexpr int kWidth_px = 800;
constexpr int kHeight_px = 700;

PieceSettings pieces_of_40_to_80_px() {
  PieceSettings pieces;
  pieces.min_scale_px = 40;
  pieces.max_scale_px = 80;
  return pieces;
}

const std::vector<Shape>& library() {
  static const std::vector<Shape> shapes = test::synthetic_library(4);
  return shapes;
}

PoseRange any_pose(const Placement&) { return {40, 80, {}}; }

std::vector<Placement> any_placements() {
  std::vector<Placement> placements(*rc::gen::inRange<std::size_t>(0, 40));
  for (Placement& p : placements) {
    const auto number = [](int low, int high) { return float(*rc::gen::inRange(low, high)); };
    p = {ShapeId(*rc::gen::inRange(0u, 4u)),
         {number(28, 56), number(28, 56), number(0, kWidth_px), number(0, kHeight_px)},
         0,
         0};
  }
  return placements;
}

Canvas any_canvas() {
  return *rc::gen::arbitrary<bool>() ? make_seamless_canvas(kWidth_px, kHeight_px, true, *rc::gen::arbitrary<bool>())
                                     : make_rectangle_canvas(kWidth_px, kHeight_px);
}

bool holds(const Box& outer, const Box& inner) {
  return std::min(inner.low.x - outer.low.x, inner.low.y - outer.low.y) >= 0 &&
         std::min(outer.high.x - inner.high.x, outer.high.y - inner.high.y) >= 0;
}

std::ptrdiff_t times_in(const std::vector<WindowPiece>& pieces, const WindowPiece& piece) {
  return std::count_if(pieces.begin(), pieces.end(), [&](const WindowPiece& p) {
    return p.shape == piece.shape && p.canvas_from_shape == piece.canvas_from_shape;
  });
}

/// Only the one window that holds a piece moves it. Every window knows all pieces that reach into it.
RC_GTEST_PROP(CanvasWindows, move_what_they_hold_and_know_what_reaches_in, ()) {
  const PieceSettings pieces = pieces_of_40_to_80_px();
  const Canvas canvas = any_canvas();
  const FreeField free(canvas, pieces);
  test::VectorShapes shapes(library());
  const std::vector<PosedPiece> all = posed_pieces(any_placements(), shapes, any_pose);
  const std::size_t given = all.empty() ? 0 : *rc::gen::inRange<std::size_t>(0, all.size());
  const float part_x = 0.01f * float(*rc::gen::inRange(0, 100));
  const float part_y = 0.01f * float(*rc::gen::inRange(0, 100));
  std::vector<int> moves(all.size(), 0);
  for (const CutWindow& cut : CanvasWindows(free, pieces, {}).cut(all, given, part_x, part_y)) {
    RC_ASSERT(!cut.moving.empty());
    RC_ASSERT(cut.moving.size() == cut.window.moving.size());
    for (std::size_t k = 0; k < cut.moving.size(); ++k) {
      ++moves[cut.moving[k]];
      RC_ASSERT(cut.window.moving[k].shape == all[cut.moving[k]].piece.shape);
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (const Vec2 offset : canvas.period.offsets()) {
        WindowPiece piece = all[i].piece;
        piece.canvas_from_shape = moved(piece.canvas_from_shape, offset);
        const Box box{all[i].box.low + offset, all[i].box.high + offset};
        const bool is_known = times_in(cut.window.moving, piece) + times_in(cut.window.still, piece) > 0;
        if (within_reach(cut.window.box, box, 0)) RC_ASSERT(is_known);
        if (i >= given && holds(cut.window.box, box)) RC_ASSERT(times_in(cut.window.moving, piece) > 0);
      }
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i) RC_ASSERT(moves[i] <= (i < given ? 0 : 1));
}

/// The stop check is called before each piece and each window, and its exception is passed on.
TEST(CanvasWindows, WorkOnThemStopsWhereItIsAskedTo) {
  const PieceSettings pieces = pieces_of_40_to_80_px();
  const FreeField free(make_rectangle_canvas(kWidth_px, kHeight_px), pieces);
  test::VectorShapes shapes(library());
  const std::vector<Placement> placements = {{ShapeId{0}, {45, 0, 100, 100}, 0, 0},
                                             {ShapeId{1}, {45, 0, 600, 500}, 0, 0}};
  int asked = 0;
  const std::vector<PosedPiece> all = posed_pieces(placements, shapes, any_pose, [&] { ++asked; });
  EXPECT_EQ(asked, 2);
  const StopCheck stop = stop_check([&] { return --asked == 0 ? std::optional(StopReason::signal) : std::nullopt; });
  EXPECT_THROW(posed_pieces(placements, shapes, any_pose, stop), Interrupted);
  asked = 3;
  EXPECT_THROW(CanvasWindows(free, pieces, {}).cut(all, 0, 0.5f, 0.5f, stop), Interrupted);
}

TEST(CanvasWindows, KnowTheJobsSizesDistancesAndCosts) {
  PieceSettings pieces = pieces_of_40_to_80_px();
  pieces.padding_px = 3;
  const FreeField free(make_rectangle_canvas(300, 220), pieces);
  const RepetitionCosts costs{0.1, 5000, 0.3, 2};
  ReplacementWindow window;
  window.box = {{0, 0}, {300, 220}};
  CanvasWindows(free, pieces, costs).complete(window);
  EXPECT_NEAR(window.distances.soft_px, 3.3, 1e-5);
  EXPECT_NEAR(window.distances.hard_px, 3.1, 1e-5);
  EXPECT_EQ(window.least_scale_px, 40);
  EXPECT_EQ(window.most_scale_px, 80);
  EXPECT_EQ(window.repetition, costs);
  EXPECT_GT(window.edge.distance.value.width(), 3) << "a small window feels the edge";
}

}  // namespace test_canvas_windows
}  // namespace tessera
