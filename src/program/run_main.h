// The common part of programs with sub-commands: errors, signals, exit codes, and ranks that end together.
#pragma once

#include <functional>

#include "program/command.h"

namespace tessera {

/// The body of main. Runs the command that `parse` finds in the command line, as one rank of a job. Returns the exit
/// code (terminal/exit_codes.h). An error, also one that `parse` throws, is reported once and ends all ranks.
int run_main(int argc, char** argv, const std::function<Command()>& parse);

}  // namespace tessera
