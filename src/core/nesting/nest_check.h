// Whether a layout keeps its promises, by the pieces' own outlines and by nothing that the search uses.
#pragma once

#include <string>

#include "core/nesting/nest_problem.h"

namespace tessera {

/// Depth to which pieces may lie in each other or beyond the strip, and by how much they may be too near, parts of the
/// strip's height.
inline constexpr double kNestTolerance = 1e-6;

/// Nothing where all is well; else what is wrong, for a message: pieces that overlap or are too near, stick out, are
/// missing or too many, or are turned by an angle that they may not have.
std::string nest_fault(const NestProblem& problem, const NestLayout& layout);

/// How deep two outlines lie in each other: the largest distance from the boundary of one at which the other's boundary,
/// or its middle, lies inside. 0: they touch, or less.
double nest_depth(const NestRing& a, const NestRing& b);

/// The least distance between two outlines, 0 where they meet.
double nest_distance(const NestRing& a, const NestRing& b);

}  // namespace tessera
