// The canvas' edge as a replacement window knows it.
#include "core/replacing/window_edge.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/relax/edge_distance.h"

namespace tessera {
namespace test_window_edge {

/// Windows know the canvas' edge up to this distance, or up to the padding if that is larger.
constexpr float kFar_px = 64;

PieceSettings pieces_of_40_to_80_px(float padding_px = 0) {
  PieceSettings pieces;
  pieces.min_scale_px = 40;
  pieces.max_scale_px = 80;
  pieces.padding_px = padding_px;
  return pieces;
}

/// Padding does not move the edge.
TEST(WindowEdge, IsThatOfTheCanvasAsFarAsPiecesFeelIt) {
  for (const float padding_px : {0.f, 3.f, 100.f}) {
    const PieceSettings pieces = pieces_of_40_to_80_px(padding_px);
    for (const Canvas& canvas : {make_rectangle_canvas(800, 700), make_seamless_canvas(800, 700, true, false)}) {
      const FreeField free(canvas, pieces);
      for (const Box& box : {Box{{-64, -64}, {380, 310}}, Box{{380, 310}, {864, 764}}}) {
        const EdgeField field = edge_around(box, free, pieces);
        const EdgeDistance edge(field.distance, field.node_px);
        for (float y = box.low.y - 70; y < box.high.y + 70; y += 13.3f) {
          for (float x = box.low.x - 70; x < box.high.x + 70; x += 17.7f) {
            const float to_top = std::min(y, 700 - y);
            const float to_side = canvas.period.x_px > 0 ? to_top : std::min(x, 800 - x);
            if (std::min(to_top, to_side) < 0) continue;
            const float felt_px = std::max(kFar_px, padding_px);
            EXPECT_NEAR(std::min(edge.at({x, y}).value, felt_px), std::min({to_top, to_side, felt_px}), 1.1f)
                << x << ", " << y;
          }
        }
      }
    }
  }
}

/// The window moves away from the corner until no piece in it feels the edge.
TEST(WindowEdge, FarAwayThereIsNone) {
  const PieceSettings pieces = pieces_of_40_to_80_px();
  const FreeField free(make_rectangle_canvas(1500, 1300), pieces);
  bool was_near = false;
  bool was_far = false;
  for (float from_px = 60; from_px < 300; from_px += 7) {
    const Box box{{from_px, from_px}, {from_px + 350, from_px + 350}};
    const EdgeField field = edge_around(box, free, pieces);
    const bool none = field.distance.value.width() == 3;
    const float nearest_px = from_px - 80;
    EXPECT_TRUE(none ? nearest_px > kFar_px : nearest_px < kFar_px + 4) << nearest_px;
    (none ? was_far : was_near) = true;
    if (!none) continue;
    const EdgeDistance edge(field.distance, field.node_px);
    for (float y = box.low.y - 79; y < box.high.y + 79; y += 58) {
      for (float x = box.low.x - 79; x < box.high.x + 79; x += 62) EXPECT_GE(edge.at({x, y}).value, 1000);
    }
  }
  EXPECT_TRUE(was_near && was_far);
}

}  // namespace test_window_edge
}  // namespace tessera
