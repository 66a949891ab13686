// The library file that a command writes: what it may replace, and how the shapes of others come into it.
#pragma once

#include <string>
#include <vector>

#include "library/library_view.h"

namespace tessera::cli {

/// Before time is spent: throws InputError where one of the files that are read has the temporary name of `output`.
void check_is_not_built_from(const std::vector<std::string>& files, const std::string& output);

/// What is replaced must be a library: a slip of the pen names a drawing. Throws InputError.
void check_replaceable(const std::string& output);

/// Copies what `choice` says into a new library, with progress on stderr and what came of it on stdout. What `choice`
/// reads is never replaced. The list of what an earlier build of `output` left out is replaced by that of the twins.
/// Throws InputError and EnvironmentError; then nothing has changed.
void copy_to_library(const LibraryChoice& choice, const std::string& output);

}  // namespace tessera::cli
