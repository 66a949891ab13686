// Another program, run to its end.
#pragma once

#include <string>
#include <vector>

namespace tessera::bench {

/// `command[0]` is looked for in PATH; the program reads nothing and writes where this one does. Throws
/// EnvironmentError where it cannot be started or does not exit with 0.
void run_program(const std::vector<std::string>& command);

/// "a  b" -> {"a", "b"}.
std::vector<std::string> words_of(const std::string& text);

}  // namespace tessera::bench
