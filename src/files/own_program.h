// Where the program that runs lies.
#pragma once

#include <string>

namespace tessera {

/// The path of this process's own program, without links. Throws EnvironmentError where the system does not tell, as
/// without /proc.
std::string own_program();

}  // namespace tessera
