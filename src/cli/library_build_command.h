// tessera library build: artwork files in, a library file and a table of what could not be used out.
#pragma once

#include <CLI/CLI.hpp>

#include "cli/commands.h"

namespace tessera::cli {

void add_library_build_command(CLI::App& library, Command& selected);

}  // namespace tessera::cli
