// Outlines of nested pieces: polygons of doubles, in the unit of the input. On a strip of several metres floats would not
// be exact enough for a layout.
#pragma once

#include <vector>

namespace tessera {

struct NestPoint {
  double x = 0;
  double y = 0;

  friend bool operator==(const NestPoint&, const NestPoint&) = default;
};

inline NestPoint operator+(NestPoint a, NestPoint b) { return {a.x + b.x, a.y + b.y}; }
inline NestPoint operator-(NestPoint a, NestPoint b) { return {a.x - b.x, a.y - b.y}; }
inline NestPoint operator*(NestPoint a, double k) { return {a.x * k, a.y * k}; }
inline double dot(NestPoint a, NestPoint b) { return a.x * b.x + a.y * b.y; }
inline double cross(NestPoint a, NestPoint b) { return a.x * b.y - a.y * b.x; }
/// Twice the area of the triangle, positive where it turns left.
inline double turn(NestPoint a, NestPoint b, NestPoint c) { return cross(b - a, c - a); }
double norm(NestPoint a);

/// A closed polygon; the last point is joined to the first.
using NestRing = std::vector<NestPoint>;

struct NestBox {
  NestPoint low;
  NestPoint high;

  double width() const { return high.x - low.x; }
  double height() const { return high.y - low.y; }
};

NestBox box_of(const NestRing& ring);  // of at least one point
/// Whether the inner box lies in the outer one; sides may touch.
bool holds(const NestBox& outer, const NestBox& inner);
double signed_area(const NestRing& ring);
/// Even-odd rule; points on the boundary may count as inside or outside.
bool contains(const NestRing& ring, NestPoint p);
double distance_to_boundary(const NestRing& ring, NestPoint p);

/// Whether the closed segments ab and cd have a point in common.
bool segments_meet(NestPoint a, NestPoint b, NestPoint c, NestPoint d);
/// Whether the inner parts of ab and cd cross in one point; touching does not count.
bool segments_cross(NestPoint a, NestPoint b, NestPoint c, NestPoint d);
/// Whether two sides cross; sides that touch do not.
bool crosses_itself(const NestRing& ring);

NestRing convex_hull(NestRing points);

/// Cosine and sine of an angle in degrees, with the same bits on all machines; exact at multiples of 90.
struct NestTurn {
  double cosine = 1;
  double sine = 0;

  NestPoint apply(NestPoint p) const { return {p.x * cosine - p.y * sine, p.x * sine + p.y * cosine}; }
};
NestTurn turn_of(double angle_deg);

}  // namespace tessera
