// Another program, run to its end.
#pragma once

#include <string>
#include <vector>

namespace tessera::bench {

/// Whether what a program prints on stdout is seen; errors are.
enum class Talk { yes, no };

/// `command[0]` is looked for in PATH; the program reads nothing and writes where this one does. Throws
/// EnvironmentError where it cannot be started or does not exit with 0.
void run_program(const std::vector<std::string>& command, Talk talk = Talk::yes);

/// Whether PATH has a program of this name.
bool is_in_path(const std::string& program);

/// "a  b" -> {"a", "b"}.
std::vector<std::string> words_of(const std::string& text);

}  // namespace tessera::bench
