// How a collage is run, whichever command runs it: the options, and what is said at an end with work left.
#pragma once

#include <CLI/CLI.hpp>

#include <string>

#include "run/collage_run.h"

namespace tessera::cli {

/// Adds all options but the job. `default_out`: where the result goes without --out, for the help. `arguments` must
/// outlive the parsing.
void add_collage_options(CLI::App& command, CollageArguments& arguments,
                         const std::string& default_out = "out/<name of the job file>");

/// run_collage, to be called on every rank. Says on stderr how to go on where work is left.
int collage_exit_code(const CollageArguments& arguments, comm::Communicator& ranks);

}  // namespace tessera::cli
