// tessera library subset: some shapes of a library, chosen by their names, as a library file.
#pragma once

#include <CLI/CLI.hpp>

#include "program/command.h"

namespace tessera::cli {

void add_library_subset_command(CLI::App& library, Command& selected);

}  // namespace tessera::cli
