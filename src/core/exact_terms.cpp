#include "core/exact_terms.h"

#include "core/distance_transform.h"
#include "core/tuning.h"

namespace tessera {
namespace {

constexpr float kOverlapDepth_px = 0.25f;  // less is rounding of the fields
constexpr int kRim = 2;  // nodes at the window's edge, whose surroundings are cut off

}  // namespace

ExactAreas exact_areas(const Shape& shape, const Similarity& canvas_from_shape, const FreeField& free,
                       const OpenedField& opened, const PieceSettings& pieces) {
  const CanvasField& field = free.field();
  const float reach_px = reachable_radius_px(pieces);
  const Window window =
      piece_window(shape.outline, canvas_from_shape, field.origin, 2 * reach_px + 3).intersected(field.value.bounds());
  ExactAreas areas;
  if (window.width() <= 2 * kRim || window.height() <= 2 * kRim) return areas;

  const Similarity shape_from_canvas = canvas_from_shape.inverse();
  const float scale = canvas_from_shape.scale();
  Grid<float> piece(window.width(), window.height());
  Grid<std::uint8_t> open_after(window.width(), window.height());
  for (int y = window.y0; y < window.y1; ++y) {
    for (int x = window.x0; x < window.x1; ++x) {
      const Vec2 p{field.origin.x + float(x), field.origin.y + float(y)};
      const float to_piece = scale * shape.field.at(shape_from_canvas.apply(p)) - pieces.padding_px;
      const float d = field.value(x, y);
      piece(x - window.x0, y - window.y0) = to_piece;
      open_after(x - window.x0, y - window.y0) = std::min(d, to_piece) > reach_px;
      if (to_piece < 0 && d < -kOverlapDepth_px) ++areas.overlap_px2;
    }
  }
  const Grid<float> squared = squared_distance_to(open_after);
  const float limit = (reach_px + 1.2f) * (reach_px + 1.2f);
  for (int y = window.y0 + kRim; y < window.y1 - kRim; ++y) {
    for (int x = window.x0 + kRim; x < window.x1 - kRim; ++x) {
      const int i = x - window.x0;
      const int j = y - window.y0;
      if (piece(i, j) >= 0 && squared(i, j) > limit && field.value(x, y) > 0 && opened.reachable(x, y)) {
        ++areas.gap_px2;
      }
    }
  }
  return areas;
}

}  // namespace tessera
