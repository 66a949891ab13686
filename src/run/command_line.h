// The command that this process was started with, for the records of a run.
#pragma once

#include <string>
#include <vector>

namespace tessera {

/// The words as a shell takes them (shell_word.h).
std::string quoted_command(const std::vector<std::string>& words);

/// The command line of this process; empty where the system does not tell.
std::string own_command_line();

}  // namespace tessera
