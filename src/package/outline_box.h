// The bounding box of an outline.
#pragma once

#include <algorithm>
#include <limits>

#include "tessera/matching/outline.h"

namespace tessera::matching {

struct OutlineBox {
  Point low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  void add(const Curve& curve) {
    for (const Point p : curve.points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  bool contains(Point p) const { return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y; }
  double extent() const { return std::max(high.x - low.x, high.y - low.y); }
  Point middle() const { return {low.x + (high.x - low.x) / 2, low.y + (high.y - low.y) / 2}; }
};

/// The bounding box of all curves.
inline OutlineBox box_of(const Outline& outline) {
  OutlineBox box;
  for (const Curve& curve : outline.curves) box.add(curve);
  return box;
}

}  // namespace tessera::matching
