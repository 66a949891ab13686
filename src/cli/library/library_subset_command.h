// tessera library subset: writes some shapes of a library, chosen by name, as a library file.
#pragma once

#include <CLI/CLI.hpp>

#include "program/command.h"

namespace tessera::cli {

void add_library_subset_command(CLI::App& library, Command& selected);

}  // namespace tessera::cli
