// The list of artwork that did not come into a library: NAME.left_out.txt beside NAME.h5 (docs/library-format.md).
#pragma once

#include <string>

#include "library/library_builder.h"

namespace tessera {

/// The path of the list: "animals.left_out.txt" for "animals.h5".
std::string left_out_path(const std::string& library);

/// The text of the list: a line for each file with what happened, the path and the reason, separated by tabs. Empty where
/// nothing was left out.
std::string left_out_list(const LibraryBuildReport& report);

/// Checks, before the build, that the list can be written. Throws InputError where another file
/// has the name of the list, EnvironmentError where the list cannot be written.
void check_left_out_list(const std::string& library);

/// Writes the list after a build of `library`, whether it wrote a library or not. Where nothing was left out, removes the
/// list of an earlier build. Throws EnvironmentError.
void write_left_out_list(const std::string& library, const LibraryBuildReport& report);

}  // namespace tessera
