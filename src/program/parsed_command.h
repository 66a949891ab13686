// The command line of a program with sub-commands.
#pragma once

#include <CLI/CLI.hpp>

#include "program/command.h"

namespace tessera {

/// Parses the command line by `app`, whose sub-commands fill `selected` when they are given. The command prints the help
/// or the version where these are asked for. Throws InputError where the command line has a mistake.
Command parsed_command(CLI::App& app, Command& selected, int argc, char** argv);

}  // namespace tessera
