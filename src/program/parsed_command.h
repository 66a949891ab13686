// The command line of a program with sub-commands.
#pragma once

#include <CLI/CLI.hpp>

#include "program/command.h"

namespace tessera {

/// Parses the command line with `app`, whose sub-commands fill `selected`. Where help or the version is asked for, the
/// returned command prints it. Throws InputError where the command line has a mistake.
Command parsed_command(CLI::App& app, Command& selected, int argc, char** argv);

}  // namespace tessera
