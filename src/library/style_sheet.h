// Draws a library in groups of similar style.
#pragma once

#include <string>
#include <vector>

#include "core/style/style_groups.h"
#include "library/storage/library_file.h"

namespace tessera {

/// Writes a PNG with one group after the other, each in rows of its own, from the typical drawing to the most different
/// one. Of a large group it shows evenly chosen drawings. Returns the number of drawings shown. Throws as
/// write_contact_sheet().
std::size_t write_style_sheet(const LibraryFile& library, const std::vector<StyleGroup>& groups,
                              const std::string& path);

}  // namespace tessera
