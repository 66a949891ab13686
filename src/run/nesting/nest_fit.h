// Names pieces that are too large for the material, before a search begins.
#pragma once

#include <string>

#include "products/nesting/layout/nest_problem.h"
#include "products/nesting/nest_input.h"

namespace tessera {

/// Names the pieces that fit onto the strip or sheet at none of their angles; empty: all fit. Where no piece fits, throws
/// InputError that names `path` and some of them. The problem's items are the input's sources.
std::string too_large_text(const NestInput& input, const NestProblem& problem, const std::string& path);

/// Says that the layout takes more sheets than there are; empty: there are enough.
std::string stock_text(const NestBin& sheet, int sheets);

}  // namespace tessera
