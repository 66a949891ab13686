// The path of the running program, and of programs in the same folder.
#pragma once

#include <string>

namespace tessera {

/// The path of this process's own program, with links resolved. Throws EnvironmentError where the system does not tell
/// it, e.g. without /proc.
std::string own_program();

/// The path of the program `name` in the folder of own_program(), if it exists. Throws as own_program() does.
std::string program_beside_own(const std::string& name);

}  // namespace tessera
