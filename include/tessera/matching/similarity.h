/// @file
/// Points of the plane, and similarity transforms of it: rotation, uniform scale and translation, without mirroring.
#pragma once

#include <cmath>

namespace tessera::matching {

/// A point or a direction, in the unit of the curves it belongs to.
struct Point {
  double x = 0;
  double y = 0;
};

inline bool operator==(Point p, Point q) { return p.x == q.x && p.y == q.y; }

/// Maps (x, y) to (a x - b y + tx, b x + a y + ty). A variable of this type is named target_from_source: `a_from_b` maps
/// points of B to points of A.
struct Similarity {
  double a = 1;   ///< scale times the cosine of the rotation
  double b = 0;   ///< scale times the sine of the rotation
  double tx = 0;  ///< in units of the target
  double ty = 0;  ///< in units of the target

  Point apply(Point p) const { return {a * p.x - b * p.y + tx, b * p.x + a * p.y + ty}; }

  /// Units of the target for one unit of the source.
  double scale() const { return std::hypot(a, b); }

  /// The rotation in (-pi, pi], from the x axis towards the y axis: clockwise on a picture, where y points down.
  double rotation_rad() const { return std::atan2(b, a); }

  Similarity inverse() const {
    const double k = 1 / (a * a + b * b);
    return {a * k, -b * k, -(a * tx + b * ty) * k, (b * tx - a * ty) * k};
  }
};

/// The transform that applies `inner` first, then `outer`.
inline Similarity operator*(const Similarity& outer, const Similarity& inner) {
  const Point t = outer.apply({inner.tx, inner.ty});
  return {outer.a * inner.a - outer.b * inner.b, outer.b * inner.a + outer.a * inner.b, t.x, t.y};
}

}  // namespace tessera::matching
