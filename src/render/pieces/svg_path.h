// Writes curves as the data of an SVG path.
#pragma once

#include <string>
#include <vector>

#include "core/geometry/similarity.h"
#include "core/geometry/vec2.h"

namespace tessera {

/// The data of closed curves, with three decimals.
std::string svg_path(const std::vector<std::vector<Vec2>>& curves, const Similarity& target_from_source);

}  // namespace tessera
