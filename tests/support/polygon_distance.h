// Distances between polygons by brute force in double precision: every segment against every other.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/polygon.h"

namespace tessera::test {

struct Point {
  double x;
  double y;
};

inline Point point(Vec2 p) { return {p.x, p.y}; }

inline double turn(Point a, Point b, Point c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

inline double distance_to(Point p, Point a, Point b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double length2 = dx * dx + dy * dy;
  const double t = length2 > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length2, 0., 1.) : 0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

inline double segment_distance(Point a, Point b, Point c, Point d) {
  if (turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0) return 0;
  return std::min(std::min(distance_to(a, c, d), distance_to(b, c, d)),
                  std::min(distance_to(c, a, b), distance_to(d, a, b)));
}

/// The distance between the curves of two outlines; 0 if they cross.
inline double boundary_distance(const Outline& one, const Outline& other) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& u : one.curves) {
    for (std::size_t i = 0, j = u.size() - 1; i < u.size(); j = i++) {
      for (const auto& v : other.curves) {
        for (std::size_t k = 0, l = v.size() - 1; k < v.size(); l = k++) {
          least = std::min(least, segment_distance(point(u[j]), point(u[i]), point(v[l]), point(v[k])));
        }
      }
    }
  }
  return least;
}

inline bool lies_in(const Outline& outline, Vec2 p) {
  bool inside = false;
  for (const auto& curve : outline.curves) inside ^= contains(curve, p);
  return inside;
}

/// The distance between two filled outlines; 0 if they cross or one lies inside the other.
inline double polygon_distance(const Outline& one, const Outline& other) {
  if (lies_in(one, other.curves[0][0]) || lies_in(other, one.curves[0][0])) return 0;
  return boundary_distance(one, other);
}

}  // namespace tessera::test
