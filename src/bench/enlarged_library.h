// A library file of any size from one of some size.
#pragma once

#include <cstdint>
#include <string>

#include "io/library/library_file.h"

namespace tessera::bench {

/// Writes the first `count` shapes, beyond the library's own its mirrored and stretched ones (varied_shapes.h), without
/// their artwork. Throws EnvironmentError.
void write_library_of_size(const io::LibraryFile& library, std::uint32_t count, const std::string& path);

}  // namespace tessera::bench
