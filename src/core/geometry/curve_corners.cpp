#include "core/geometry/curve_corners.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tessera {
namespace {

float distance_to_chord(Vec2 p, Vec2 from, Vec2 to) {
  const Vec2 chord = to - from;
  const float length = norm(chord);
  return length > 0 ? std::abs(cross(chord, p - from)) / length : norm(p - from);
}

std::size_t farthest_from_first(const std::vector<Vec2>& curve) {
  std::size_t farthest = 0;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    if (norm(curve[i] - curve[0]) > norm(curve[farthest] - curve[0])) farthest = i;
  }
  return farthest;
}

}  // namespace

std::vector<std::size_t> curve_corners(const std::vector<Vec2>& curve, float tolerance) {
  const std::size_t middle = farthest_from_first(curve);
  std::vector<std::size_t> corners{0};
  if (middle > 0) corners.push_back(middle);
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, middle}, {middle, curve.size()}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    float most = tolerance;
    std::size_t corner = from;
    for (std::size_t i = from + 1; i < to; ++i) {
      const float away = distance_to_chord(curve[i], curve[from], curve[to % curve.size()]);
      if (away <= most) continue;
      most = away;
      corner = i;
    }
    if (corner == from) continue;
    corners.push_back(corner);
    open.emplace_back(from, corner);
    open.emplace_back(corner, to);
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

}  // namespace tessera
