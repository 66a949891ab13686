// A spatial index of closed polygons: their segments in cells, for exact distances to points and segments.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/polygon.h"

namespace tessera {

struct Segment {
  Vec2 from;
  Vec2 to;
};

Vec2 nearest_point(const Segment& segment, Vec2 p);

/// The nearest points of two objects, and their distance.
struct Approach {
  float distance = 0;
  Vec2 here;
  Vec2 there;
};

/// The nearest points of two segments; the distance is 0 if the segments cross.
Approach approach_of(const Segment& here, const Segment& there);

class PolygonIndex {
 public:
  /// The outline has at least one curve of at least one point.
  explicit PolygonIndex(Outline outline);

  const Outline& outline() const { return outline_; }
  const Box& box() const { return box_; }

  /// Even-odd rule over all curves; points on the boundary may count either way.
  bool contains(Vec2 p) const;

  /// The nearest points of a point or a segment (`here`) and of the boundary (`there`). If the boundary is farther than
  /// `reach`, the distance is `reach` and the points have no meaning.
  Approach approach(Vec2 here, float reach) const { return approach(Segment{here, here}, reach); }
  Approach approach(const Segment& here, float reach) const;
  /// Whether the boundary is nearer to `p` than `reach`. Stops at the first such segment.
  bool nearer_than(float reach, Vec2 p) const;

 private:
  struct Cells {
    int x0, y0, x1, y1;
  };
  int column(float x) const;
  int row(float y) const;
  Cells cells_round(const Segment& s, float reach) const;
  template <class F>
  void each_segment(F f) const;
  /// Calls f(segment) for the segments in the cells within `reach` of `s`, until it returns false.
  template <class F>
  void each_near(const Segment& s, float reach, F f) const;

  Outline outline_;
  Box box_;
  float cells_per_unit_ = 0;
  int columns_ = 1;
  int rows_ = 1;
  std::vector<Segment> segments_;     // by cell; a segment in several cells is listed in each of them
  std::vector<std::uint32_t> first_;  // the first index of each cell in segments_, and the end
};

/// The nearest points of two boundaries. If these are farther apart than `reach`, the distance is `reach` and the
/// points have no meaning.
Approach approach_of(const PolygonIndex& here, const PolygonIndex& there, float reach);

}  // namespace tessera
