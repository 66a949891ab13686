// Paths deformed with their piece's outline (core/deform/warp.h).
#pragma once

#include <cstddef>

#include "artwork/svg/path_steps.h"
#include "core/deform/warp.h"

namespace tessera {

/// Bézier curves and lines along the image of the path, which is in the warp's frame: no farther from it than `tolerance`
/// in the same unit, up to 1,024 to each step of the path. Takes one of `steps_left` for each; throws InputError where
/// there are none left.
PathSteps warped_path(const PathSteps& path, const Warp& warp, double tolerance, std::size_t& steps_left);

}  // namespace tessera
