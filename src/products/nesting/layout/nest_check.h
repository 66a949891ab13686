// Whether a layout keeps its promises, by the pieces' own outlines and by nothing that the search uses.
#pragma once

#include <functional>
#include <string>

#include "core/base/stop.h"
#include "products/nesting/layout/nest_problem.h"

namespace tessera {

/// Depth to which pieces may lie in each other or beyond the strip, and by how much they may be too near, parts of the
/// strip's height.
inline constexpr double kNestTolerance = 1e-6;

/// Nothing where all is well; else what is wrong, for a message: pieces that overlap or are too near, stick out, are
/// missing or too many, or are turned by an angle that they may not have. `check_stop`, if any, is called for each two
/// pieces that are near each other; what it throws ends the check.
std::string nest_fault(const NestProblem& problem, const NestLayout& layout, const StopCheck& check_stop = never_stop);

/// Whether a point of one outline's boundary, or its middle, lies inside the other one and farther than `depth` from
/// the other's boundary.
bool lie_deeper(const NestRing& a, const NestRing& b, double depth);

/// Whether two points of the boundaries are nearer to each other than `distance`.
bool are_nearer(const NestRing& a, const NestRing& b, double distance);

}  // namespace tessera
