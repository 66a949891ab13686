// The options and the final messages of commands that run a collage.
#pragma once

#include <CLI/CLI.hpp>

#include <string>

#include "run/collage_run.h"

namespace tessera::cli {

/// Adds all options except the job. `default_out`: the output folder without --out, for the help. `arguments` must
/// outlive the parsing.
void add_collage_options(CLI::App& command, CollageArguments& arguments,
                         const std::string& default_out = "out/<name of the job file>");

/// Calls run_collage and returns its exit code; to be called on every rank. Where work is left it says on stderr how to
/// go on.
int collage_exit_code(const CollageArguments& arguments, comm::Communicator& ranks);

}  // namespace tessera::cli
