// What the arguments of tessera nest make of its drawings: a problem with bounds.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "products/nesting/layout/nest_problem.h"
#include "products/nesting/nest_input.h"
#include "run/nesting/nest_run.h"

namespace tessera {

/// Throws InputError, which names the option.
void check_arguments(const NestArguments& arguments);

/// How many of the shapes of which name: of "name=3", "name" being a pattern. Throws InputError.
std::vector<std::pair<std::string, int>> demands_of(const std::vector<std::string>& texts);

/// The sheet that pieces are laid on: that of the command, or the instance's; nothing: a strip.
std::optional<NestBin> sheet_of(const NestArguments& arguments, const NestInput& input);

/// Throws InputError where the material has no size, or there are too many pieces or points.
NestProblem problem_of(const NestArguments& arguments, const NestInput& input);

}  // namespace tessera
