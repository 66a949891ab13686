// Lines and arcs of a drawing joined to closed contours.
#pragma once

#include <cstddef>
#include <vector>

#include "products/nesting/layout/nest_polygon.h"

namespace tessera {

struct JoinedLine {
  std::size_t number = 0;  // among the lines given
  bool backwards = false;
};

struct JoinedContour {
  NestRing ring;
  std::vector<JoinedLine> lines;  // that it consists of, from its first point on
};

/// Closed contours, without the first point at their end: lines that are closed, and those whose ends meet within
/// `reach`, in the order of their first lines. What stays open or encloses nothing is counted. A line that is there
/// twice counts once.
std::vector<JoinedContour> joined_contours(const std::vector<NestRing>& lines, double reach, int& open);

}  // namespace tessera
