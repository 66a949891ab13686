#include "core/geometry/polygon.h"

namespace tessera {

AreaMoment area_moment(const std::vector<Vec2>& polygon) {
  AreaMoment sum;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const double ax = polygon[j].x, ay = polygon[j].y, bx = polygon[i].x, by = polygon[i].y;
    const double twice = ax * by - ay * bx;
    sum += {twice / 2, twice * (ax + bx) / 6, twice * (ay + by) / 6};
  }
  return sum;
}

AreaMoment area_moment(const Outline& outline) {
  AreaMoment sum;
  for (const std::vector<Vec2>& curve : outline.curves) sum += area_moment(curve);
  return sum;
}

double signed_area(const std::vector<Vec2>& polygon) { return area_moment(polygon).area; }

Box bounding_box(const std::vector<Vec2>& polygon) {
  Box box{polygon.front(), polygon.front()};
  for (const Vec2 p : polygon) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

Box bounding_box(const Outline& outline) {
  Box box = bounding_box(outline.curves.front());
  for (const std::vector<Vec2>& curve : outline.curves) box = united(box, bounding_box(curve));
  return box;
}

Box united(const Box& a, const Box& b) {
  return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
          {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

bool contains(const std::vector<Vec2>& polygon, Vec2 p) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2 a = polygon[j], b = polygon[i];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y))) inside = !inside;
  }
  return inside;
}

}  // namespace tessera
