// tessera library extract: makes a library of the stones, tiles or coins in photographs.
#pragma once

#include <CLI/CLI.hpp>

#include "program/command.h"

namespace tessera::cli {

void add_library_extract_command(CLI::App& library, Command& selected);

}  // namespace tessera::cli
