// Copies shapes of libraries into a new library file, without tracing them again.
#pragma once

#include <functional>
#include <string>

#include "library/storage/shape_library.h"

namespace tessera {

/// Writes the new file, which has the content digest of `library`. Only one shape at a time is in memory. Calls `done` with
/// the number of shapes written. Throws InputError where a shape is damaged, EnvironmentError where the file cannot be
/// written; an older file then stays as it was.
void copy_library(const ShapeLibrary& library, const std::string& output, const std::function<void(std::size_t)>& done);

}  // namespace tessera
