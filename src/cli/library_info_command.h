// tessera library info: what is in a library file, as tables and as a contact sheet.
#pragma once

#include <CLI/CLI.hpp>

#include "cli/commands.h"

namespace tessera::cli {

void add_library_info_command(CLI::App& library, Command& selected);

}  // namespace tessera::cli
