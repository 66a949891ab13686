// The command that started this process, for the records of a run.
#pragma once

#include <string>
#include <vector>

namespace tessera {

/// The words in a form that a shell reads back (shell_word.h).
std::string quoted_command(const std::vector<std::string>& words);

/// The command line of this process; empty where the system does not tell it.
std::string own_command_line();

}  // namespace tessera
