// The convex hull of points.
#pragma once

#include <vector>

#include "core/geometry/polygon.h"

namespace tessera {

/// The corners of the smallest convex polygon that holds the points, with its interior on the left (positive shoelace
/// area, as an Outline's outer curve); none on a straight side. Of fewer than three corners where the points lie on a line.
std::vector<Vec2> convex_hull(std::vector<Vec2> points);

/// The width of the narrowest strip that holds a convex polygon; 0 of fewer than three corners.
double least_width(const std::vector<Vec2>& hull);

}  // namespace tessera
