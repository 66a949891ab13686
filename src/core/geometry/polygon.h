// Outlines, and basic measures of closed polygons.
#pragma once

#include <algorithm>
#include <vector>

#include "core/geometry/vec2.h"

namespace tessera {

/// Closed polygons; the last point is joined to the first. curve[0] is the outer boundary, the others are holes. Every
/// curve has the shape's interior on its left: positive shoelace area for the outer curve, negative for holes.
struct Outline {
  std::vector<std::vector<Vec2>> curves;

  friend bool operator==(const Outline&, const Outline&) = default;
};

/// Shoelace area and its first moment. Both are signed: the sums over an outer curve and its holes are those of the
/// shape.
struct AreaMoment {
  double area = 0;
  double x = 0;  // integral of x over the area
  double y = 0;

  AreaMoment& operator+=(const AreaMoment& o) {
    area += o.area;
    x += o.x;
    y += o.y;
    return *this;
  }
};

struct Box {
  Vec2 low;
  Vec2 high;

  float width() const { return high.x - low.x; }
  float height() const { return high.y - low.y; }
};

/// Whether the distance of the boxes is at most `reach` in x and in y.
inline bool within_reach(const Box& a, const Box& b, float reach) {
  return a.low.x <= b.high.x + reach && b.low.x <= a.high.x + reach && a.low.y <= b.high.y + reach &&
         b.low.y <= a.high.y + reach;
}

AreaMoment area_moment(const std::vector<Vec2>& polygon);
AreaMoment area_moment(const Outline& outline);  // sum over all curves
double signed_area(const std::vector<Vec2>& polygon);
Box bounding_box(const std::vector<Vec2>& polygon);  // needs at least one point
Box bounding_box(const Outline& outline);            // needs at least one curve
Box united(const Box& a, const Box& b);              // the smallest box that contains both

/// Even-odd rule; points on the boundary may count either way.
bool contains(const std::vector<Vec2>& polygon, Vec2 p);

}  // namespace tessera
