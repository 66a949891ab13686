// Writes the shapes of libraries as a library file of their own: nothing is traced again.
#pragma once

#include <functional>
#include <string>

#include "library/storage/shape_library.h"

namespace tessera {

/// The new file has the content digest of `library`. One shape at a time is in memory. `done` is called with the number
/// of shapes written. Throws InputError where a shape is damaged, EnvironmentError where the file cannot be written:
/// then there is no new file, and an older one stays.
void copy_library(const ShapeLibrary& library, const std::string& output, const std::function<void(std::size_t)>& done);

}  // namespace tessera
