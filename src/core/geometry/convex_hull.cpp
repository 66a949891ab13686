#include "core/geometry/convex_hull.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>

namespace tessera {
namespace {

bool turns_left(Vec2 a, Vec2 b, Vec2 c) {
  return (double(b.x) - a.x) * (double(c.y) - a.y) - (double(b.y) - a.y) * (double(c.x) - a.x) > 0;
}

/// Appends the chain of corners from the first point to the last but one; `points` are sorted along it.
template <class Points>
void append_chain(const Points& points, std::vector<Vec2>& corners) {
  const std::size_t begin = corners.size();
  for (const Vec2 p : points) {
    while (corners.size() >= begin + 2 && !turns_left(corners[corners.size() - 2], corners.back(), p))
      corners.pop_back();
    corners.push_back(p);
  }
  corners.pop_back();
}

}  // namespace

std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(), [](Vec2 a, Vec2 b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Vec2> corners;
  append_chain(points, corners);
  std::reverse(points.begin(), points.end());
  append_chain(points, corners);
  return corners;
}

/// One side of the narrowest strip contains a side of the polygon.
double least_width(const std::vector<Vec2>& hull) {
  if (hull.size() < 3) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = hull.size() - 1; i < hull.size(); j = i++) {
    const double x = double(hull[i].x) - hull[j].x;
    const double y = double(hull[i].y) - hull[j].y;
    double most = 0;
    for (const Vec2 p : hull) most = std::max(most, x * (double(p.y) - hull[j].y) - y * (double(p.x) - hull[j].x));
    least = std::min(least, most / std::sqrt(x * x + y * y));
  }
  return least;
}

}  // namespace tessera
