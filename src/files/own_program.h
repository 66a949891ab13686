// Where the program that runs lies, and those beside it.
#pragma once

#include <string>

namespace tessera {

/// The path of this process's own program, without links. Throws EnvironmentError where the system does not tell, as
/// without /proc.
std::string own_program();

/// Where a program of this name lies, if it is there: in the folder of own_program(). Throws as that does.
std::string program_beside_own(const std::string& name);

}  // namespace tessera
