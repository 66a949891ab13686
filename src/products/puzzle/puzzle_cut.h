// A rectangle, or another shape, cut into puzzle pieces whose boundaries agree with each other.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/vec2.h"

namespace tessera {

/// Tabs: a grid with wavering lines, each side with a tab of its own form. Polygons: the cells of points that lie at
/// random, but not near each other; three meet at a corner. Rectangles: a plain grid, all alike.
enum class CutStyle { tabs, polygons, rectangles };

struct CutRequest {
  int width_px = 0;
  int height_px = 0;
  int pieces = 0;  // at least 2
  CutStyle style = CutStyle::tabs;
  std::uint64_t seed = 1;
  std::vector<Vec2> outline = {};  // of what is cut, interior on the left, within the rectangle; empty: all of it
};

/// Polygons in the frame's coordinates, px, y down, each with its interior on the left (positive shoelace area).
/// Together they cover the frame, or the outline, once. Of tabs there may be a few more or fewer than wished: rows times
/// columns of about square pieces; of an outline's pieces, too, as it cuts some, and small parts go to a neighbour. The
/// same request gives the same pieces.
std::vector<std::vector<Vec2>> cut_puzzle(const CutRequest& request);

}  // namespace tessera
