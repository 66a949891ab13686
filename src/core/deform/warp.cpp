#include "core/deform/warp.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace tessera {
namespace {

/// Twice the area of the triangle's image.
float doubled_area(Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - a); }

float least_jacobian_of_cell(const Warp& warp, int i, int j) {
  const Vec2 p00 = warp.warped_node(i, j), p10 = warp.warped_node(i + 1, j);
  const Vec2 p01 = warp.warped_node(i, j + 1), p11 = warp.warped_node(i + 1, j + 1);
  const float least = warp.falling ? std::min(doubled_area(p00, p10, p11), doubled_area(p00, p11, p01))
                                   : std::min(doubled_area(p00, p10, p01), doubled_area(p10, p11, p01));
  return least / (warp.step * warp.step);
}

}  // namespace

WarpWeights Warp::weights_at(Vec2 p) const {
  const int columns = displacement.width(), rows = displacement.height();
  const float u = std::clamp((p.x - origin.x) / step, 0.f, float(columns - 1));
  const float v = std::clamp((p.y - origin.y) / step, 0.f, float(rows - 1));
  const int i = std::min(int(u), columns - 2), j = std::min(int(v), rows - 2);
  const float s = u - float(i), t = v - float(j);
  if (falling) {
    if (s >= t) return {{i, i + 1, i + 1}, {j, j, j + 1}, {1 - s, s - t, t}};
    return {{i, i + 1, i}, {j, j + 1, j + 1}, {1 - t, s, t - s}};
  }
  if (s + t <= 1) return {{i, i + 1, i}, {j, j, j + 1}, {1 - s - t, s, t}};
  return {{i + 1, i + 1, i}, {j, j + 1, j + 1}, {1 - t, s + t - 1, 1 - s}};
}

Vec2 Warp::apply(Vec2 p) const {
  const WarpWeights at = weights_at(p);
  Vec2 moved = p;
  for (int k = 0; k < 3; ++k) moved = moved + displacement(at.x[k], at.y[k]) * at.weight[k];
  return moved;
}

float Warp::least_jacobian() const {
  float least = 1;
  for (int j = 0; j < active.height(); ++j) {
    for (int i = 0; i < active.width(); ++i) {
      if (active(i, j)) least = std::min(least, least_jacobian_of_cell(*this, i, j));
    }
  }
  return least;
}

Warp spread(const Warp& warp, Vec2 low, Vec2 high) {
  const int left = std::max(0, int(std::ceil((warp.origin.x - low.x) / warp.step)));
  const int above = std::max(0, int(std::ceil((warp.origin.y - low.y) / warp.step)));
  const Vec2 origin = warp.origin - Vec2{warp.step * float(left), warp.step * float(above)};
  const int columns = std::max(warp.displacement.width() + left, int(std::ceil((high.x - origin.x) / warp.step)) + 1);
  const int rows = std::max(warp.displacement.height() + above, int(std::ceil((high.y - origin.y) / warp.step)) + 1);
  Warp wide{.origin = origin,
            .step = warp.step,
            .displacement = {columns, rows},
            .active = {columns - 1, rows - 1, 1},
            .falling = warp.falling};
  Grid<std::uint8_t> known(columns, rows, 0);
  std::vector<std::pair<int, int>> reached;  // nodes in the order of their distance from what is active
  const auto reach = [&](int x, int y, Vec2 displacement) {
    if (x < 0 || y < 0 || x >= columns || y >= rows || known(x, y)) return;
    known(x, y) = 1;
    wide.displacement(x, y) = displacement;
    reached.emplace_back(x, y);
  };
  for (int j = 0; j < warp.active.height(); ++j) {
    for (int i = 0; i < warp.active.width(); ++i) {
      if (!warp.active(i, j)) continue;
      for (const auto& [x, y] : {std::pair{i, j}, {i + 1, j}, {i, j + 1}, {i + 1, j + 1}})
        reach(x + left, y + above, warp.displacement(x, y));
    }
  }
  for (std::size_t k = 0; k < reached.size(); ++k) {
    const auto [x, y] = reached[k];
    const Vec2 displacement = wide.displacement(x, y);
    for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) reach(x + dx, y + dy, displacement);
  }
  return wide;
}

Outline warped_outline(Outline outline, const Warp& warp) {
  for (std::vector<Vec2>& curve : outline.curves) {
    for (Vec2& p : curve) p = warp.apply(p);
  }
  return outline;
}

Warp in_frame(const Warp& warp, float scale, Vec2 offset, bool mirrored) {
  const int columns = warp.displacement.width(), rows = warp.displacement.height();
  Warp moved{.origin = {},
             .step = warp.step * scale,
             .displacement = {columns, rows},
             .active = {columns - 1, rows - 1},
             .falling = warp.falling != mirrored};
  const float left = mirrored ? -warp.node(columns - 1, 0).x : warp.origin.x;
  moved.origin = Vec2{left, warp.origin.y} * scale + offset;
  const float side = mirrored ? -1.f : 1.f;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const Vec2 d = warp.displacement(mirrored ? columns - 1 - i : i, j);
      moved.displacement(i, j) = Vec2{side * d.x, d.y} * scale;
      if (i + 1 < columns && j + 1 < rows) moved.active(i, j) = warp.active(mirrored ? columns - 2 - i : i, j);
    }
  }
  return moved;
}

}  // namespace tessera
