// Intersects and joins polygons, to cut a shape along the sides of cells.
#pragma once

#include <optional>
#include <vector>

#include "core/geometry/vec2.h"

namespace tessera {

/// The parts of `cell` that lie in `outline`; both are simple and have the interior on the left, and so have the parts. Two
/// cells with a common side give parts with the same points there, to the bit.
std::vector<std::vector<Vec2>> common_parts(const std::vector<Vec2>& cell, const std::vector<Vec2>& outline);

/// The length of the boundary along which two polygons touch, in edges with the same ends.
double shared_length(const std::vector<Vec2>& a, const std::vector<Vec2>& b);

/// Both as one polygon; empty where they enclose a hole or do not touch along edges.
std::optional<std::vector<Vec2>> joined(const std::vector<Vec2>& a, const std::vector<Vec2>& b);

}  // namespace tessera
