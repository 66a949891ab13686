// Distance of points to the convex hull of other points.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/geometry/vec2.h"

namespace tessera {

/// A lower bound of the distance to any curve through the points. It is the distance to the polygon of the hull's
/// tangents in 32 evenly spaced directions. Outside the hull it is at most half a percent less than the distance to the
/// hull.
class HullDistance {
 public:
  explicit HullDistance(const std::vector<Vec2>& points) {
    farthest_.fill(-INFINITY);
    for (const Vec2& p : points) {
      for (int k = 0; k < kDirections; ++k) {
        const float along = p.x * directions().x[k] + p.y * directions().y[k];
        farthest_[k] = along > farthest_[k] ? along : farthest_[k];
      }
    }
  }

  /// The bound at `p`; negative inside.
  float at(Vec2 p) const {
    std::array<float, kDirections> beyond;
    for (int k = 0; k < kDirections; ++k) {
      beyond[k] = p.x * directions().x[k] + p.y * directions().y[k] - farthest_[k];
    }
    for (int width = kDirections / 2; width > 0; width /= 2) {
      for (int k = 0; k < width; ++k) beyond[k] = beyond[k] > beyond[k + width] ? beyond[k] : beyond[k + width];
    }
    return beyond[0];
  }

 private:
  static constexpr int kDirections = 32;
  struct Directions {
    std::array<float, kDirections> x;
    std::array<float, kDirections> y;
  };
  static const Directions& directions() {
    static const Directions made = [] {
      Directions d;
      for (int k = 0; k < kDirections; ++k) {
        const double angle = 2 * std::numbers::pi * k / kDirections;
        d.x[k] = float(std::cos(angle));
        d.y[k] = float(std::sin(angle));
      }
      return d;
    }();
    return made;
  }

  std::array<float, kDirections> farthest_;  // largest projection of a point on each direction
};

}  // namespace tessera
