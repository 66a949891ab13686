#include "products/nesting/layout/nest_polygon.h"

#include <algorithm>
#include <cmath>

namespace tessera {

double norm(NestPoint a) { return std::sqrt(dot(a, a)); }

NestBox box_of(const NestRing& ring) {
  NestBox box{ring.front(), ring.front()};
  for (const NestPoint p : ring) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

bool holds(const NestBox& outer, const NestBox& inner) {
  return outer.low.x <= inner.low.x && outer.low.y <= inner.low.y && inner.high.x <= outer.high.x &&
         inner.high.y <= outer.high.y;
}

double signed_area(const NestRing& ring) {
  double twice = 0;
  for (std::size_t i = 2; i < ring.size(); ++i) twice += turn(ring[0], ring[i - 1], ring[i]);
  return twice / 2;
}

bool contains(const NestRing& ring, NestPoint p) {
  bool inside = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const NestPoint a = ring[i], b = ring[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * ((p.y - a.y) / (b.y - a.y)) + a.x) inside = !inside;
  }
  return inside;
}

double distance_to_boundary(const NestRing& ring, NestPoint p) {
  double least = -1;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const NestPoint side = ring[i] - ring[j], to = p - ring[j];
    const double length2 = dot(side, side);
    const double t = length2 > 0 ? std::clamp(dot(to, side) / length2, 0.0, 1.0) : 0.0;
    const NestPoint off = to - side * t;
    const double distance2 = dot(off, off);
    if (least < 0 || distance2 < least) least = distance2;
  }
  return std::sqrt(least);
}

bool segments_meet(NestPoint a, NestPoint b, NestPoint c, NestPoint d) {
  if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
      std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y))
    return false;
  const double c_of_ab = turn(a, b, c), d_of_ab = turn(a, b, d);
  if ((c_of_ab > 0 && d_of_ab > 0) || (c_of_ab < 0 && d_of_ab < 0)) return false;
  const double a_of_cd = turn(c, d, a), b_of_cd = turn(c, d, b);
  return !((a_of_cd > 0 && b_of_cd > 0) || (a_of_cd < 0 && b_of_cd < 0));
}

bool segments_cross(NestPoint a, NestPoint b, NestPoint c, NestPoint d) {
  const double c_of_ab = turn(a, b, c), d_of_ab = turn(a, b, d);
  if (!((c_of_ab > 0 && d_of_ab < 0) || (c_of_ab < 0 && d_of_ab > 0))) return false;
  const double a_of_cd = turn(c, d, a), b_of_cd = turn(c, d, b);
  return (a_of_cd > 0 && b_of_cd < 0) || (a_of_cd < 0 && b_of_cd > 0);
}

bool crosses_itself(const NestRing& ring) {
  struct Side {
    double low_x, high_x;
    NestPoint from, to;
  };
  std::vector<Side> sides;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    sides.push_back({std::min(ring[i].x, ring[j].x), std::max(ring[i].x, ring[j].x), ring[j], ring[i]});
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.low_x < b.low_x; });
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (std::size_t j = i + 1; j < sides.size() && sides[j].low_x <= sides[i].high_x; ++j) {
      if (segments_cross(sides[i].from, sides[i].to, sides[j].from, sides[j].to)) return true;
    }
  }
  return false;
}

NestRing convex_hull(NestRing points) {
  std::sort(points.begin(), points.end(),
            [](NestPoint a, NestPoint b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  NestRing hull;
  const auto add = [&](NestPoint p, std::size_t keep) {
    while (hull.size() >= keep + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
    hull.push_back(p);
  };
  for (const NestPoint p : points) add(p, 0);
  const std::size_t lower = hull.size() - 1;
  for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
  if (hull.size() > 1) hull.pop_back();
  return hull;
}

NestTurn turn_of(double angle_deg) {
  double quarters = std::floor(angle_deg / 90 + 0.5);
  const double x = (angle_deg - quarters * 90) * (3.14159265358979323846 / 180);  // |x| <= pi / 4
  const double x2 = x * x;
  // Taylor series, to 1e-17.
  const double sine =
      x *
      (1 - x2 / 6 * (1 - x2 / 20 * (1 - x2 / 42 * (1 - x2 / 72 * (1 - x2 / 110 * (1 - x2 / 156 * (1 - x2 / 210)))))));
  const double cosine =
      1 - x2 / 2 * (1 - x2 / 12 * (1 - x2 / 30 * (1 - x2 / 56 * (1 - x2 / 90 * (1 - x2 / 132 * (1 - x2 / 182))))));
  quarters -= 4 * std::floor(quarters / 4);
  switch (int(quarters)) {
    case 1: return {-sine, cosine};
    case 2: return {-cosine, -sine};
    case 3: return {sine, -cosine};
    default: return {cosine, sine};
  }
}

}  // namespace tessera
