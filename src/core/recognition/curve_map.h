// A map of curves: gives the nearest point of the curves for any point near them.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/geometry/grid.h"
#include "core/recognition/curve.h"

namespace tessera {

class CurveMap {
 public:
  /// `curves`: at least one, each of evenly spaced points that lie closer together than `cell`. Points farther from all
  /// curves than `reach` count as far. Both lengths are in the curves' own units.
  CurveMap(const std::vector<Curve>& curves, float cell, float reach);

  struct Nearest {
    float distance = std::numeric_limits<float>::infinity();
    float along = 0;      // arclength from the first curve's start
    Vec2 point;           // on the curve
    Vec2 tangent;         // unit
    bool at_end = false;  // an open curve ends here: it may have continued to a nearer place
  };

  /// The nearest point of the curves; its distance is infinite if p is far. Between branches that are about equally
  /// near (within a cell) it may belong to the other branch.
  Nearest nearest(Vec2 p) const;
  /// A fast estimate of nearest() from the points of the curves alone. It is too large by at most half their spacing.
  struct Rough {
    float squared_distance = std::numeric_limits<float>::infinity();
    std::uint32_t point = 0;
  };
  Rough rough(Vec2 p) const {
    Rough rough;
    const int i = int((p.x - origin_.x) * cells_per_unit_);
    const int j = int((p.y - origin_.y) * cells_per_unit_);
    if (p.x < origin_.x || p.y < origin_.y || i >= place_.width() || j >= place_.height()) return rough;
    const std::uint32_t place = place_(i, j);
    if (place == kNoPlace) return rough;
    const Vec2 d = p - points_[place].position;
    rough.squared_distance = dot(d, d);
    rough.point = place;
    return rough;
  }

  Vec2 tangent(std::uint32_t point) const { return points_[point].tangent; }
  /// The length of all curves together.
  float length() const { return length_; }

 private:
  static constexpr std::uint32_t kNoPlace = ~0u;

  struct Point {
    Vec2 position;
    Vec2 tangent;
    float along;
    std::uint32_t before;  // itself at the beginning of an open curve
    std::uint32_t after;
  };

  void add_points(const Curve& curve);
  void add_cells(float cell, float reach);

  std::vector<Point> points_;
  float length_ = 0;
  Vec2 origin_;
  float cells_per_unit_ = 1;
  Grid<std::uint32_t> place_;  // per cell: the point nearest to its middle
};

}  // namespace tessera
