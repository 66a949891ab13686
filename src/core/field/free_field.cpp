#include "core/field/free_field.h"

#include <algorithm>
#include <cmath>

#include "core/field/line_art.h"
#include "core/field/piece_distance.h"
#include "core/geometry/extent.h"
#include "core/settings/tuning.h"
#include "core/shape/shape_field.h"

namespace tessera {

Window piece_window(const Outline& outline, const Similarity& canvas_from_shape, Vec2 origin, float margin_px) {
  return nodes_round(extent_of(outline.curves.front(), canvas_from_shape), origin, margin_px);
}

PeriodicGrid free_field_grid(const Canvas& canvas, const PieceSettings& pieces) {
  const Window own = canvas.distance.value.bounds();
  const int reach = int(std::ceil(kSeamlessReach * pieces.max_scale_px));
  const int beyond_x = std::min(reach, canvas.period.x_px);
  const int beyond_y = std::min(reach, canvas.period.y_px);
  const Window nodes{0, 0, own.x1 + 2 * beyond_x, own.y1 + 2 * beyond_y};
  Window one_period = nodes;
  if (canvas.period.x_px > 0) {
    one_period.x0 = beyond_x + kCanvasMargin;
    one_period.x1 = one_period.x0 + canvas.period.x_px;
  }
  if (canvas.period.y_px > 0) {
    one_period.y0 = beyond_y + kCanvasMargin;
    one_period.y1 = one_period.y0 + canvas.period.y_px;
  }
  return {nodes, one_period, canvas.period};
}

FreeField::FreeField(const Canvas& canvas, const PieceSettings& pieces)
    : grid_(free_field_grid(canvas, pieces)),
      empty_(grid_.nodes().width(), grid_.nodes().height()),
      padding_px_(kept_distance_px(pieces)),
      hard_depth_px_(hard_depth_px(pieces)),
      band_px_(stamp_band_px(pieces)),
      has_zones_(canvas.has_zones()) {
  const Grid<float>& distance = canvas.distance.value;
  const int beyond_x = (empty_.width() - distance.width()) / 2;
  const int beyond_y = (empty_.height() - distance.height()) / 2;
  const Window& one_period = grid_.one_period();
  for (int y = one_period.y0; y < one_period.y1; ++y) {
    for (int x = one_period.x0; x < one_period.x1; ++x) {
      const float d = distance(x - beyond_x, y - beyond_y) - padding_px_;
      empty_(x, y) = d;
      free_256ths_px2_ += node_256ths_px2(d);
    }
  }
  grid_.spread(empty_, one_period, grid_.nodes());
  field_ = {empty_, canvas.distance.origin - Vec2{float(beyond_x), float(beyond_y)}};
}

FieldView FreeField::canvas_view() const {
  FieldView canvas = view();
  canvas.value = empty_.data().data();
  return canvas;
}

FieldSample FreeField::canvas_sample(Vec2 canvas_px) const {
  FieldSample sample = field_sample(canvas_view(), canvas_px);
  sample.value += padding_px_;
  return sample;
}

std::int64_t FreeField::node_256ths_px2(float distance_px) const {
  return std::int64_t(256 * std::clamp(distance_px + padding_px_ + 0.5f, 0.f, 1.f));
}

Window FreeField::stamp_window(const Shape& shape, const Similarity& canvas_from_shape) const {
  return grid_.clipped(piece_window(shape.outline, canvas_from_shape, field_.origin, band_px_));
}

void FreeField::clear(const Window& window) {
  for (const Window& part : grid_.images(window, grid_.one_period())) {
    for (int y = part.y0; y < part.y1; ++y) {
      for (int x = part.x0; x < part.x1; ++x) {
        float& d = field_.value(x, y);
        free_256ths_px2_ += node_256ths_px2(empty_(x, y)) - node_256ths_px2(d);
        d = empty_(x, y);
      }
    }
  }
  grid_.spread(field_.value, window, grid_.nodes());
}

Window FreeField::stamp(const Shape& shape, const Similarity& canvas_from_shape) {
  return stamp(shape, canvas_from_shape, stamp_window(shape, canvas_from_shape));
}

/// Changes nodes of the one period only, each by the distance at the image of the node that lies in the window.
Window FreeField::stamp(const Shape& shape, const Similarity& canvas_from_shape, const Window& window) {
  const PieceDistance piece(shape, canvas_from_shape, padding_px_);
  const float line_radius_px = line_radius(shape.field, shape.perimeter) * canvas_from_shape.scale() + padding_px_;
  const StoredDepth held(hard_depth_px_, line_radius_px);
  Window changed;
  const Window& one_period = grid_.one_period();
  for (int y = window.y0; y < window.y1;) {
    const int rows = std::min(window.y1 - y, one_period.y1 - grid_.row(y));
    for (int x = window.x0; x < window.x1;) {
      const int columns = std::min(window.x1 - x, one_period.x1 - grid_.column(x));
      changed = changed.united(stamp_part(piece, held, {x, y, x + columns, y + rows}));
      x += columns;
    }
    y += rows;
  }
  grid_.spread(field_.value, changed, grid_.nodes());
  return changed;
}

/// Stamps a part of the window whose image in the one period is also a window.
Window FreeField::stamp_part(const PieceDistance& piece, const StoredDepth& held, const Window& part) {
  const int to_image = grid_.column(part.x0) - part.x0;
  Window changed;
  for (int y = part.y0; y < part.y1; ++y) {
    float* row = field_.value.row(grid_.row(y)) + to_image;
    int first = part.x1;
    int end = part.x0;
    for (int x = part.x0; x < part.x1;) {
      const float d = piece.at({field_.origin.x + float(x), field_.origin.y + float(y)});
      if (const float now = held(d); now < row[x]) {
        free_256ths_px2_ += node_256ths_px2(now) - node_256ths_px2(row[x]);
        row[x] = now;
        first = std::min(first, x);
        end = x + 1;
      }
      // Continues at the next node where the piece may be nearer than the present value.
      const int here = x++;
      while (x < part.x1 && held(d - PieceDistance::most_change_px(float(x - here))) >= row[x]) ++x;
    }
    if (first < end) changed = changed.united({first, y, end, y + 1});
  }
  return changed;
}

}  // namespace tessera
