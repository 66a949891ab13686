// What two polygons have in common, and two that touch as one: for cutting a shape along the sides of cells.
#pragma once

#include <optional>
#include <vector>

#include "core/geometry/vec2.h"

namespace tessera {

/// The parts of `cell` that lie in `outline`, both simple and with the interior on the left, as are the parts. Two
/// cells with one side between them give parts with the same points there, to the bit.
std::vector<std::vector<Vec2>> common_parts(const std::vector<Vec2>& cell, const std::vector<Vec2>& outline);

/// Length of the boundary along which two polygons touch, of edges with the same ends.
double shared_length(const std::vector<Vec2>& a, const std::vector<Vec2>& b);

/// Both as one polygon; nothing where they enclose a hole or do not touch along edges.
std::optional<std::vector<Vec2>> joined(const std::vector<Vec2>& a, const std::vector<Vec2>& b);

}  // namespace tessera
