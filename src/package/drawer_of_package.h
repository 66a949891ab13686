// Finds the program tessera-drawer for a library that is loaded by any program.
#pragma once

#include <string>

namespace tessera::matching {

/// The file that TESSERA_DRAWER names, else the one that was installed with this library: its place is known from that
/// of the library, so that an installation can be moved. Throws EnvironmentError where there is none.
std::string drawer_of_package();

}  // namespace tessera::matching
