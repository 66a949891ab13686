// The convex hull of a set of points.
#pragma once

#include <vector>

#include "core/geometry/polygon.h"

namespace tessera {

/// The corners of the smallest convex polygon that contains the points, with its interior on the left (positive
/// shoelace area, as an Outline's outer curve). No corner lies on a straight side. Points on a line give fewer than
/// three corners.
std::vector<Vec2> convex_hull(std::vector<Vec2> points);

/// The width of the narrowest strip that contains a convex polygon; 0 for fewer than three corners.
double least_width(const std::vector<Vec2>& hull);

}  // namespace tessera
