// Makes a problem of the arguments of tessera nest and its drawings, within bounds.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "products/nesting/layout/nest_problem.h"
#include "products/nesting/nest_input.h"
#include "run/nesting/nest_run.h"

namespace tessera {

/// Throws InputError that names the option.
void check_arguments(const NestArguments& arguments);

/// Reads "name=3", where "name" is a pattern: which shapes, and how many of each. Throws InputError.
std::vector<std::pair<std::string, int>> demands_of(const std::vector<std::string>& texts);

/// The sheet on which pieces are laid: the command's, or the instance's; empty: a strip.
std::optional<NestBin> sheet_of(const NestArguments& arguments, const NestInput& input);

/// Makes the problem. Throws InputError where the material has no size, or there are too many pieces or points.
NestProblem problem_of(const NestArguments& arguments, const NestInput& input);

}  // namespace tessera
