// Windows of simple shapes for tests of replacement trials.
#pragma once

#include <cmath>
#include <map>
#include <vector>

#include "core/relaxed_pieces.h"
#include "core/replacing/hole_shape.h"
#include "core/replacing/replacement.h"
#include "core/replacing/window_pieces.h"

namespace tessera::replaced_pieces {

inline constexpr int kCanvas_px = 200;

inline const std::vector<HoleShape>& hole_shapes() {
  static const std::vector<HoleShape> all = [] {
    std::vector<HoleShape> made;
    for (const Shape& shape : relaxed_pieces::shapes()) made.push_back(make_hole_shape(shape));
    return made;
  }();
  return all;
}

inline const HoleShapes& shapes_by_id() {
  static const HoleShapes all = [] {
    HoleShapes shapes;
    for (std::uint32_t i = 0; i < hole_shapes().size(); ++i) shapes[ShapeId{i}] = &hole_shapes()[i];
    return shapes;
  }();
  return all;
}

inline ContactPiece laid(std::size_t shape, const Similarity& where) {
  ContactPiece piece;
  piece.lay(hole_shapes()[shape].contact, where);
  return piece;
}

/// The exact box of the placed outline.
inline Box box_of(ShapeId shape, const Similarity& where) {
  std::vector<Vec2> points;
  for (const Vec2 p : relaxed_pieces::shapes()[index_of(shape)].outline.curves.front())
    points.push_back(where.apply(p));
  return bounding_box(points);
}

inline bool holds(const Box& outer, const Box& inner, float inside_px) {
  return inner.low.x >= outer.low.x + inside_px && inner.low.y >= outer.low.y + inside_px &&
         inner.high.x <= outer.high.x - inside_px && inner.high.y <= outer.high.y - inside_px;
}

/// The canvas' edge distances at every second px, over `box` and `beyond_px` around it.
inline EdgeField edge_field(const FreeField& free, const Box& box, float beyond_px) {
  constexpr float kNode_px = 2;
  const Vec2 low = (box.low - Vec2{beyond_px, beyond_px}) * (1 / kNode_px);
  const Vec2 origin{std::floor(low.x), std::floor(low.y)};
  const int columns = int((box.width() + 2 * beyond_px) / kNode_px) + 3;
  const int rows = int((box.height() + 2 * beyond_px) / kNode_px) + 3;
  EdgeField edge{{Grid<float>(columns, rows), origin}, kNode_px};
  const EdgeDistance canvas(free);
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      edge.distance.value(i, j) = canvas.at((origin + Vec2{float(i), float(j)}) * kNode_px).value;
    }
  }
  return edge;
}

inline WindowPiece window_piece(std::size_t shape, const Similarity& where, const PoseRange& poses = {20, 60, {}}) {
  return {ShapeId(shape), ShapeId(shape), where, poses};
}

/// Counts the drawings as if the canvas held only the window's pieces.
inline void count_drawn(ReplacementWindow& window) {
  std::map<ShapeId, double> area_px2;
  for (const IncomingShape& in : window.incoming) area_px2[in.drawing];
  for (const auto* pieces : {&window.moving, &window.still}) {
    for (const WindowPiece& p : *pieces) area_px2[p.drawing] += std::pow(double(p.canvas_from_shape.scale()), 2);
  }
  window.drawn.clear();
  for (const auto& [drawing, of_drawing_px2] : area_px2) window.drawn.push_back({drawing, of_drawing_px2});
}

/// A window of a whole square canvas without pieces. Its trials are cold, and every shape may come in.
inline ReplacementWindow empty_window(int canvas_px = kCanvas_px) {
  ReplacementWindow window;
  const float size_px = float(canvas_px);
  window.box = {{-64, -64}, {size_px + 64, size_px + 64}};
  window.edge = edge_field(relaxed_pieces::rectangle(canvas_px), window.box, 60);
  window.distances = {0, -1};
  window.least_scale_px = 20;
  window.most_scale_px = 60;
  window.repetition.even_share_px2 = 1200;
  for (std::size_t i = 0; i < hole_shapes().size(); ++i) {
    window.incoming.push_back({ShapeId(i), ShapeId(i), {20, 60, {}}, 1});
  }
  count_drawn(window);
  window.random = 7;
  window.trials = 20;
  return window;
}

inline constexpr float kDiscPitch_px = 40;
inline const float kDiscScale_px = kDiscPitch_px / 2 / relaxed_pieces::kDiscRadius;

/// Touching discs in 5 rows of 5, without the middle one.
inline std::vector<WindowPiece> discs_round_a_hole() {
  std::vector<WindowPiece> discs;
  for (int k = 0; k < 25; ++k) {
    if (k == 12) continue;
    const Vec2 at = Vec2{float(k % 5) + 0.5f, float(k / 5) + 0.5f} * kDiscPitch_px;
    discs.push_back(window_piece(relaxed_pieces::kDisc, {kDiscScale_px, 0, at.x, at.y}));
  }
  return discs;
}
inline constexpr Vec2 kMiddle{0.5f * kCanvas_px, 0.5f * kCanvas_px};

}  // namespace tessera::replaced_pieces
