// Makes a library file of any size from another library.
#pragma once

#include <cstdint>
#include <string>

#include "library/storage/library_file.h"

namespace tessera::bench {

/// Writes the first `count` shapes without their artwork; beyond the library's own these are mirrored and stretched
/// (varied_shapes.h). Throws EnvironmentError.
void write_library_of_size(const LibraryFile& library, std::uint32_t count, const std::string& path);

}  // namespace tessera::bench
