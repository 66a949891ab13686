// Finds tessera-drawer, the program of drawers.
#pragma once

#include <string>
#include <vector>

namespace tessera {

/// The path of tessera-drawer: the file in the environment variable TESSERA_DRAWER; else beside the running program (in
/// a build folder); else ../libexec/tessera/ from there (installed). Throws EnvironmentError where there is none.
std::string drawer_program();

/// The file in TESSERA_DRAWER, if that is set; otherwise the first of `files` that can be run. Throws as
/// drawer_program().
std::string drawer_program_among(const std::vector<std::string>& files);

}  // namespace tessera
