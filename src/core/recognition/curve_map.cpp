#include "core/recognition/curve_map.h"

#include <algorithm>
#include <cmath>

namespace tessera {

CurveMap::CurveMap(const std::vector<Curve>& curves, float cell, float reach) {
  for (const Curve& curve : curves) add_points(curve);
  add_cells(cell, reach);
}

void CurveMap::add_points(const Curve& curve) {
  const std::vector<Vec2> tangents = tangents_of(curve);
  const auto first = std::uint32_t(points_.size());
  const auto last = std::uint32_t(first + curve.points.size() - 1);
  for (std::uint32_t i = first; i <= last; ++i) {
    const Vec2 position = curve.points[i - first];
    if (i > first) length_ += norm(position - points_.back().position);
    const std::uint32_t before = i > first ? i - 1 : curve.closed ? last : i;
    const std::uint32_t after = i < last ? i + 1 : curve.closed ? first : i;
    points_.push_back({position, tangents[i - first], length_, before, after});
  }
  if (curve.closed) length_ += norm(points_[first].position - points_[last].position);
}

void CurveMap::add_cells(float cell, float reach) {
  Vec2 low = points_.front().position;
  Vec2 high = low;
  for (const Point& p : points_) {
    low = {std::min(low.x, p.position.x), std::min(low.y, p.position.y)};
    high = {std::max(high.x, p.position.x), std::max(high.y, p.position.y)};
  }
  cells_per_unit_ = 1 / cell;
  origin_ = low - Vec2{reach, reach};
  const Vec2 size = high - low + Vec2{2 * reach, 2 * reach};
  place_ = Grid<std::uint32_t>(int(size.x * cells_per_unit_) + 1, int(size.y * cells_per_unit_) + 1, kNoPlace);
  Grid<float> squared(place_.width(), place_.height(), reach * reach);
  const int reach_cells = int(reach * cells_per_unit_) + 1;
  for (std::uint32_t k = 0; k < points_.size(); ++k) {
    const Vec2 p = (points_[k].position - origin_) * cells_per_unit_;
    const Window near =
        Window{int(p.x), int(p.y), int(p.x) + 1, int(p.y) + 1}.grown(reach_cells).intersected(place_.bounds());
    for (int j = near.y0; j < near.y1; ++j) {
      for (int i = near.x0; i < near.x1; ++i) {
        const Vec2 d = Vec2{float(i) + 0.5f - p.x, float(j) + 0.5f - p.y} * cell;
        if (dot(d, d) >= squared(i, j)) continue;
        squared(i, j) = dot(d, d);
        place_(i, j) = k;
      }
    }
  }
}

CurveMap::Nearest CurveMap::nearest(Vec2 p) const {
  Rough best = rough(p);
  if (best.squared_distance == std::numeric_limits<float>::infinity()) return {};
  // The cell's nearest point is not always that of p: the nearest point of p may be some steps along the curve.
  for (bool moved = true; moved;) {
    moved = false;
    for (const std::uint32_t next : {points_[best.point].before, points_[best.point].after}) {
      const Vec2 d = p - points_[next].position;
      if (dot(d, d) >= best.squared_distance) continue;
      best = {dot(d, d), next};
      moved = true;
    }
  }
  const Point& at = points_[best.point];
  Nearest nearest{std::sqrt(best.squared_distance), at.along, at.position, at.tangent, false};
  for (const std::uint32_t next : {at.before, at.after}) {
    if (next == best.point) {
      nearest.at_end = true;
      continue;
    }
    const Vec2 edge = points_[next].position - at.position;
    const float t = dot(p - at.position, edge) / std::max(dot(edge, edge), 1e-12f);
    if (t <= 0 || t > 1) continue;
    const Vec2 foot = at.position + edge * t;
    if (norm(p - foot) >= nearest.distance) continue;
    const float step = t * norm(edge);
    nearest.distance = norm(p - foot);
    nearest.along = at.along + (next == at.after ? step : -step);
    nearest.point = foot;
    nearest.tangent = at.tangent + (points_[next].tangent - at.tangent) * t;
  }
  if (nearest.point != at.position) nearest.at_end = false;
  return nearest;
}

}  // namespace tessera
