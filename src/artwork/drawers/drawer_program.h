// Finds the program that drawers run.
#pragma once

#include <string>
#include <vector>

namespace tessera {

/// tessera-drawer: the file that the environment variable TESSERA_DRAWER names; else beside the running program, as in
/// a build folder; else ../libexec/tessera/ from there, as installed. Throws EnvironmentError where there is none.
std::string drawer_program();

/// The same, looked for among `files` where TESSERA_DRAWER names none: the first that can be run.
std::string drawer_program_among(const std::vector<std::string>& files);

}  // namespace tessera
