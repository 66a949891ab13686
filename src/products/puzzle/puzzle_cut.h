// Cuts a rectangle, or another shape, into puzzle pieces whose boundaries fit each other.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/vec2.h"

namespace tessera {

/// Tabs: a grid with wavering lines, and on each side a tab of its own form. Polygons: the cells of random points that are
/// not near each other; three meet at a corner. Rectangles: a plain grid of equal pieces.
enum class CutStyle { tabs, polygons, rectangles };

struct CutRequest {
  int width_px = 0;
  int height_px = 0;
  int pieces = 0;  // at least 2
  CutStyle style = CutStyle::tabs;
  std::uint64_t seed = 1;
  // of the shape to cut, interior on the left, within the rectangle; empty: the whole rectangle
  std::vector<Vec2> outline = {};
};

/// Polygons in the frame's coordinates, px, y down, each with its interior on the left (positive shoelace area). Together
/// they cover the frame, or the outline, once. The number of pieces may differ a little from the wish: tabs are rows times
/// columns of about square pieces; an outline cuts some pieces, and small parts go to a neighbour. The same request gives
/// the same pieces.
std::vector<std::vector<Vec2>> cut_puzzle(const CutRequest& request);

}  // namespace tessera
