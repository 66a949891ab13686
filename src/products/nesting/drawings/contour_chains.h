// Lines and arcs of a drawing joined to closed contours.
#pragma once

#include <vector>

#include "products/nesting/layout/nest_polygon.h"

namespace tessera {

/// Closed contours, without the first point at their end: lines that are closed, and those whose ends meet within
/// `reach`, in the order of their first lines. What stays open or encloses nothing is counted. A line that is there
/// twice counts once.
std::vector<NestRing> joined_contours(std::vector<NestRing> lines, double reach, int& open);

}  // namespace tessera
