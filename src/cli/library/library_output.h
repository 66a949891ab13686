// The library file that a command writes: what it may replace, and how shapes of other libraries are copied into it.
#pragma once

#include <string>
#include <vector>

#include "library/library_view.h"

namespace tessera::cli {

/// Throws InputError where one of the input files has the temporary name of `output`. To be called before the work.
void check_is_not_built_from(const std::vector<std::string>& files, const std::string& output);

/// Throws InputError where `output` exists and is no library: a mistyped name must not replace a drawing.
void check_replaceable(const std::string& output);

/// Copies the chosen shapes into a new library, with progress on stderr and the result on stdout. Never replaces a file
/// that `choice` reads. The list of left-out files from an earlier build of `output` is replaced by the list of twins
/// that were merged. Throws InputError and EnvironmentError; nothing has changed then.
void copy_to_library(const LibraryChoice& choice, const std::string& output);

}  // namespace tessera::cli
