// What the programs with sub-commands have in common: errors, signals, exit codes, and ranks that end together.
#pragma once

#include <functional>

#include "program/command.h"

namespace tessera {

/// What main returns: runs the command that `parse` finds in the command line as one rank of a job, which reports errors
/// once and ends all ranks together. What `parse` throws is reported so, too. Exit codes: terminal/exit_codes.h.
int run_main(int argc, char** argv, const std::function<Command()>& parse);

}  // namespace tessera
