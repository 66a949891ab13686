// Checks a layout by the pieces' own outlines, without any code that the search uses.
#pragma once

#include <functional>
#include <string>

#include "core/base/stop.h"
#include "products/nesting/layout/nest_problem.h"

namespace tessera {

/// Depth to which pieces may lie in each other or beyond the strip, or be too near, as a part of the strip's
/// height.
inline constexpr double kNestTolerance = 1e-6;

/// The fault of the layout, for a message; empty: there is none. Faults are: pieces that overlap or are too near, stick
/// out, are missing or too many, or have an angle that is not allowed. `check_stop` is called for each two pieces that are
/// near each other; what it throws ends the check.
std::string nest_fault(const NestProblem& problem, const NestLayout& layout, const StopCheck& check_stop = never_stop);

/// Whether a point of one outline's boundary, or its middle, lies inside the other one and farther than `depth` from its
/// boundary.
bool lie_deeper(const NestRing& a, const NestRing& b, double depth);

/// Whether two points of the boundaries are nearer to each other than `distance`.
bool are_nearer(const NestRing& a, const NestRing& b, double distance);

}  // namespace tessera
