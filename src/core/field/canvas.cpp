#include "core/field/canvas.h"

#include <cmath>

#include "core/geometry/distance_transform.h"

namespace tessera {
namespace {

Canvas empty_canvas(int width_px, int height_px) {
  Canvas canvas;
  canvas.width_px = width_px;
  canvas.height_px = height_px;
  canvas.distance.value = Grid<float>(width_px + 2 * kCanvasMargin, height_px + 2 * kCanvasMargin);
  canvas.distance.origin = {0.5f - kCanvasMargin, 0.5f - kCanvasMargin};
  return canvas;
}

}  // namespace

Canvas make_rectangle_canvas(int width_px, int height_px) {
  return make_seamless_canvas(width_px, height_px, false, false);
}

Canvas make_seamless_canvas(int width_px, int height_px, bool in_x, bool in_y) {
  Canvas canvas = empty_canvas(width_px, height_px);
  Grid<float>& d = canvas.distance.value;
  for (int j = 0; j < d.height(); ++j) {
    for (int i = 0; i < d.width(); ++i) {
      const float x = canvas.distance.origin.x + float(i);
      const float y = canvas.distance.origin.y + float(j);
      const float dx = in_x ? kNoEdge_px : std::min(x, float(width_px) - x);
      const float dy = in_y ? kNoEdge_px : std::min(y, float(height_px) - y);
      d(i, j) = dx < 0 && dy < 0 ? -std::sqrt(dx * dx + dy * dy) : std::min(dx, dy);
    }
  }
  canvas.area_px2 = double(width_px) * height_px;
  canvas.period = {in_x ? width_px : 0, in_y ? height_px : 0};
  return canvas;
}

Canvas make_mask_canvas(const Grid<float>& coverage, int cells_per_px) {
  const int rim = cells_per_px * kCanvasMargin;
  Grid<std::uint8_t> inside(coverage.width() + 2 * rim, coverage.height() + 2 * rim, 0);
  Grid<std::uint8_t> outside(inside.width(), inside.height(), 1);
  double area = 0;
  for (int y = 0; y < coverage.height(); ++y) {
    for (int x = 0; x < coverage.width(); ++x) {
      const bool in = coverage(x, y) >= 0.5f;
      inside(x + rim, y + rim) = in;
      outside(x + rim, y + rim) = !in;
      area += in;
    }
  }
  Canvas canvas = empty_canvas(coverage.width() / cells_per_px, coverage.height() / cells_per_px);
  canvas.area_px2 = area / (cells_per_px * cells_per_px);
  if (area == 0) {
    canvas.distance.value = Grid<float>(canvas.distance.value.width(), canvas.distance.value.height(), -1.f);
    return canvas;
  }
  const Grid<float> to_outside = squared_distance_to(outside);
  const Grid<float> to_inside = squared_distance_to(inside);
  const float cell_px = 1.f / float(cells_per_px);
  // The boundary runs midway between the last cell inside and the first cell outside.
  const auto signed_px = [&](int x, int y) {
    return cell_px * (inside(x, y) ? std::sqrt(to_outside(x, y)) - 0.5f : 0.5f - std::sqrt(to_inside(x, y)));
  };
  Grid<float>& d = canvas.distance.value;
  for (int j = 0; j < d.height(); ++j) {
    for (int i = 0; i < d.width(); ++i) {
      d(i, j) = cells_per_px == 1 ? signed_px(i, j)
                                  : 0.25f * (signed_px(2 * i, 2 * j) + signed_px(2 * i + 1, 2 * j) +
                                             signed_px(2 * i, 2 * j + 1) + signed_px(2 * i + 1, 2 * j + 1));
    }
  }
  return canvas;
}

double area_px2(const CanvasField& distance, int width_px, int height_px) {
  double area = 0;
  for (int y = 0; y < height_px; ++y) {
    for (int x = 0; x < width_px; ++x) {
      const float inside_px = distance.value(x + kCanvasMargin, y + kCanvasMargin);
      area += double(std::clamp(inside_px + 0.5f, 0.f, 1.f));
    }
  }
  return area;
}

}  // namespace tessera
