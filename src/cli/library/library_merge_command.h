// tessera library merge: writes the shapes of several libraries into one library file.
#pragma once

#include <CLI/CLI.hpp>

#include "program/command.h"

namespace tessera::cli {

void add_library_merge_command(CLI::App& library, Command& selected);

}  // namespace tessera::cli
