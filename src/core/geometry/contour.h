// Sub-pixel contours by marching squares, for silhouettes. The collage's target curve has its own tracer, as it is
// traced again window by window: target_curve.h.
#pragma once

#include <vector>

#include "core/geometry/grid.h"
#include "core/geometry/vec2.h"

namespace tessera {

/// Closed polygons where the bilinear interpolation of `value` along the grid's edges equals `level`. Node (i, j) lies
/// at (i, j). Beyond the grid the value counts as 0, so that every contour closes (level > 0). Larger values lie on the
/// left: positive shoelace area around them, negative around holes. The polygons are ordered by their first crossing,
/// row by row. If opposite corners of a cell are inside, the mean of the four decides whether they are connected.
std::vector<std::vector<Vec2>> contours(const Grid<float>& value, float level);

}  // namespace tessera
