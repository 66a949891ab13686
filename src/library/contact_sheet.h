// Draws the shapes of a library: thumbnails in rows, with names.
#pragma once

#include <string>

#include "library/storage/library_file.h"

namespace tessera {

inline constexpr std::size_t kMaxSheetShapes = 400;

/// Writes a PNG. From a larger library it shows kMaxSheetShapes shapes, evenly chosen. Returns the number of shapes shown.
/// Throws InputError where the library is damaged, EnvironmentError where `path` cannot be written.
std::size_t write_contact_sheet(const LibraryFile& library, const std::string& path);

}  // namespace tessera
