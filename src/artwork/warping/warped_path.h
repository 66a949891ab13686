// Deforms paths together with their piece's outline (core/deform/warp.h).
#pragma once

#include <cstddef>

#include "artwork/svg/path_steps.h"
#include "core/deform/warp.h"

namespace tessera {

/// Bézier curves and lines along the image of the path, at most `tolerance` away from it; both are in the warp's frame
/// and unit. A step of the path becomes at most 1,024 steps. Each new step reduces `steps_left` by one; throws
/// InputError where none are left.
PathSteps warped_path(const PathSteps& path, const Warp& warp, double tolerance, std::size_t& steps_left);

}  // namespace tessera
