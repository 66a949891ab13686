// tessera library styles: shows the drawings of a library in groups of similar style.
#pragma once

#include <CLI/CLI.hpp>

#include "program/command.h"

namespace tessera::cli {

void add_library_styles_command(CLI::App& library, Command& selected);

}  // namespace tessera::cli
