// Pieces that are too large for the material are named before a search begins.
#pragma once

#include <string>

#include "products/nesting/layout/nest_problem.h"
#include "products/nesting/nest_input.h"

namespace tessera {

/// What is to be told of pieces that fit onto the strip or sheet at none of their angles; empty: all fit. Throws
/// InputError, naming `path` and some of the pieces, where none fits. The problem's items are the input's sources.
std::string too_large_text(const NestInput& input, const NestProblem& problem, const std::string& path);

/// What is to be told where the layout takes more sheets than there are; empty: there are enough.
std::string stock_text(const NestBin& sheet, int sheets);

}  // namespace tessera
