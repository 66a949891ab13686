// The outline of the whole puzzle.
#pragma once

#include <string>
#include <vector>

#include "core/geometry/vec2.h"

namespace tessera {

/// The one outline of a drawing's edge (canvas_edge.h), with the interior on the left; specks beside it do not count.
/// Throws InputError that names `path` where there are several outlines, or holes.
std::vector<Vec2> frame_outline(const std::vector<std::vector<Vec2>>& edge, const std::string& path);

}  // namespace tessera
