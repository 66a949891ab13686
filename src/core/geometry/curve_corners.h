// Simplification of closed curves.
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry/vec2.h"

namespace tessera {

/// The places in a closed curve, ascending, of the vertices that the algorithm of Douglas and Peucker keeps: no vertex is
/// farther than `tolerance` from the polygon of the kept ones. The first vertex is always kept.
std::vector<std::size_t> curve_corners(const std::vector<Vec2>& curve, float tolerance);

}  // namespace tessera
