// Finds the program tessera-drawer for a library that is loaded by any program.
#pragma once

#include <string>

namespace tessera::matching {

/// The path of the drawer: the file that TESSERA_DRAWER names, else the one installed with this library. It is found from
/// the place of the library, so that an installation can be moved. Throws EnvironmentError where there is none.
std::string drawer_of_package();

}  // namespace tessera::matching
