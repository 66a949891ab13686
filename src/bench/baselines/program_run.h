// Runs another program to its end.
#pragma once

#include <string>
#include <vector>

namespace tessera::bench {

/// Whether the output of a program on stdout is shown; errors are always shown.
enum class ProgramOutput { yes, no };

/// Runs a program. `command[0]` is searched in PATH; the program reads nothing and has our stdout and stderr. Throws
/// EnvironmentError where it cannot be started or does not exit with 0.
void run_program(const std::vector<std::string>& command, ProgramOutput talk = ProgramOutput::yes);

/// Whether PATH has a program of this name.
bool is_in_path(const std::string& program);

/// Splits at spaces: "a  b" -> {"a", "b"}.
std::vector<std::string> words_of(const std::string& text);

}  // namespace tessera::bench
