// tessera library info: shows what a library file holds, as tables and as a contact sheet.
#pragma once

#include <CLI/CLI.hpp>

#include "program/command.h"

namespace tessera::cli {

/// Checks the contact sheet's path before the work. Throws InputError where it is the name of a library or a drawing (a
/// mistyped command), and EnvironmentError where it cannot be written. Does nothing where `sheet` is empty.
void check_sheet(const std::string& sheet);

void add_library_info_command(CLI::App& library, Command& selected);

}  // namespace tessera::cli
