// The list beside a library of what its artwork did not bring into it: NAME.left_out.txt beside NAME.h5
// (docs/library-format.md).
#pragma once

#include <string>

#include "library/library_builder.h"

namespace tessera {

/// "animals.h5" has "animals.left_out.txt".
std::string left_out_path(const std::string& library);

/// A line for each file: what happened, the path, why, with tabs between them. Empty where nothing was left out.
std::string left_out_list(const LibraryBuildReport& report);

/// Before time is spent: throws InputError where another file than such a list has its name, EnvironmentError where it
/// cannot be written.
void check_left_out_list(const std::string& library);

/// Writes the list of the build of `library` that just ended, with a library or without. Where it is empty, the list of
/// the build before is removed. Throws EnvironmentError.
void write_left_out_list(const std::string& library, const LibraryBuildReport& report);

}  // namespace tessera
