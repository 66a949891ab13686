// Joins lines and arcs of a drawing to closed contours.
#pragma once

#include <cstddef>
#include <vector>

#include "products/nesting/layout/nest_polygon.h"

namespace tessera {

struct JoinedLine {
  std::size_t number = 0;  // index of the line among those given
  bool backwards = false;
};

struct JoinedContour {
  NestRing ring;
  std::vector<JoinedLine> lines;  // the lines it consists of, from its first point on
};

/// The closed contours, without the first point at their end: lines that are closed, and lines whose ends meet within
/// `reach`, in the order of their first lines. `open` counts lines that stay open or enclose nothing. A repeated line
/// counts once.
std::vector<JoinedContour> joined_contours(const std::vector<NestRing>& lines, double reach, int& open);

}  // namespace tessera
