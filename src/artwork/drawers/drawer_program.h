// Finds the program that drawers run.
#pragma once

#include <string>

namespace tessera {

/// tessera-drawer: the file that the environment variable TESSERA_DRAWER names; else beside the running program, as in
/// a build folder; else ../libexec/tessera/ from there, as installed. Throws EnvironmentError where there is none.
std::string drawer_program();

}  // namespace tessera
