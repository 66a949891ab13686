// Bounding boxes in canvas px, and the grid nodes around them.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "core/geometry/grid.h"
#include "core/geometry/similarity.h"

namespace tessera {

struct Extent {
  Vec2 low{};
  Vec2 high{};

  friend bool operator==(const Extent&, const Extent&) = default;
};

/// The bounding box of the points (at least one), transformed by the similarity.
inline Extent extent_of(std::span<const Vec2> points, const Similarity& canvas_from_shape) {
  Extent extent{canvas_from_shape.apply(points.front()), canvas_from_shape.apply(points.front())};
  for (const Vec2& q : points) {
    const Vec2 p = canvas_from_shape.apply(q);
    extent.low = {std::min(extent.low.x, p.x), std::min(extent.low.y, p.y)};
    extent.high = {std::max(extent.high.x, p.x), std::max(extent.high.y, p.y)};
  }
  return extent;
}

/// All nodes within `margin_px` of the extent, on a grid whose nodes are 1 px apart and whose node (0, 0) lies at
/// `origin`. The window may exceed the grid.
inline Window nodes_round(const Extent& extent, Vec2 origin, float margin_px) {
  const Vec2 low = extent.low - origin;
  const Vec2 high = extent.high - origin;
  return {int(std::floor(low.x - margin_px)), int(std::floor(low.y - margin_px)),
          int(std::ceil(high.x + margin_px)) + 1, int(std::ceil(high.y + margin_px)) + 1};
}

}  // namespace tessera
