// tessera library info: what is in a library file, as tables and as a contact sheet.
#pragma once

#include <CLI/CLI.hpp>

#include "program/command.h"

namespace tessera::cli {

/// Before the work: a slip of the pen must not turn a library or a drawing into a picture (InputError), and the picture
/// can be written (EnvironmentError). Nothing where `sheet` is empty.
void check_sheet(const std::string& sheet);

void add_library_info_command(CLI::App& library, Command& selected);

}  // namespace tessera::cli
