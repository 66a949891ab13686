// The outline of what a puzzle's pieces make up together.
#pragma once

#include <string>
#include <vector>

#include "core/geometry/vec2.h"

namespace tessera {

/// The one outline of a drawing's edge (canvas_edge.h), interior on the left; specks beside it do not count. Throws
/// InputError, which names `path`, where there are several, or holes.
std::vector<Vec2> frame_outline(const std::vector<std::vector<Vec2>>& edge, const std::string& path);

}  // namespace tessera
