#include "core/geometry/rasterise.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace tessera {
namespace {

struct RowCrossing {
  int row;
  float x;

  bool operator<(const RowCrossing& o) const { return std::tie(row, x) < std::tie(o.row, o.x); }
};

/// Limits a coordinate to the range of an int.
float within_int(float v) { return std::clamp(v, -1e9f, 1e9f); }

/// First row or column whose centre is at `v` or beyond it.
int first_centre_from(float v) { return int(std::ceil(within_int(v) - 0.5f)); }

void add_crossings(Vec2 p, Vec2 q, const Window& window, std::vector<RowCrossing>& crossings) {
  // Always from top to bottom, so that two outlines with a common edge cut each row at the same x.
  if (p.y > q.y) std::swap(p, q);
  const int begin = std::max(window.y0, first_centre_from(p.y));
  const int end = std::min(window.y1, first_centre_from(q.y));
  if (begin >= end) return;
  const float slope = (q.x - p.x) / (q.y - p.y);
  for (int row = begin; row < end; ++row) crossings.push_back({row, p.x + (float(row) + 0.5f - p.y) * slope});
}

std::vector<RowCrossing> sorted_crossings(const Outline& outline, const Similarity& grid_from_shape,
                                          const Window& window) {
  std::vector<RowCrossing> crossings;
  for (const std::vector<Vec2>& curve : outline.curves) {
    if (curve.empty()) continue;
    Vec2 previous = grid_from_shape.apply(curve.back());
    for (const Vec2 point : curve) {
      const Vec2 p = grid_from_shape.apply(point);
      add_crossings(previous, p, window, crossings);
      previous = p;
    }
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

}  // namespace

Window bounding_window(const Outline& outline, const Similarity& grid_from_shape) {
  if (outline.curves.empty() || outline.curves.front().empty()) return {};
  Vec2 low = grid_from_shape.apply(outline.curves.front().front());
  Vec2 high = low;
  for (const Vec2 point : outline.curves.front()) {
    const Vec2 p = grid_from_shape.apply(point);
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return {int(std::floor(within_int(low.x))), int(std::floor(within_int(low.y))), int(std::ceil(within_int(high.x))),
          int(std::ceil(within_int(high.y)))};
}

std::vector<Span> fill_spans(const Outline& outline, const Similarity& grid_from_shape, const Window& window) {
  const std::vector<RowCrossing> crossings = sorted_crossings(outline, grid_from_shape, window);
  std::vector<Span> spans;
  // Closed curves cross every row an even number of times.
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    const int x0 = std::max(window.x0, first_centre_from(crossings[i].x));
    const int x1 = std::min(window.x1, first_centre_from(crossings[i + 1].x));
    if (x0 < x1) spans.push_back({crossings[i].row, x0, x1});
  }
  return spans;
}

Grid<std::uint8_t> rasterise(const Outline& outline, const Similarity& grid_from_shape, const Window& window) {
  Grid<std::uint8_t> inside(window.width(), window.height(), 0);
  for (const Span& span : fill_spans(outline, grid_from_shape, window)) {
    std::uint8_t* row = inside.row(span.y - window.y0) - window.x0;
    std::fill(row + span.x0, row + span.x1, std::uint8_t{1});
  }
  return inside;
}

}  // namespace tessera
