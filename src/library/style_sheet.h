// A picture of a library in groups of like style.
#pragma once

#include <string>
#include <vector>

#include "core/style/style_groups.h"
#include "library/storage/library_file.h"

namespace tessera {

/// Writes a PNG: a group after the other, each in rows of its own, from the typical drawing to the outermost; of a larger
/// group evenly chosen ones. Returns how many drawings are shown. Throws as write_contact_sheet.
std::size_t write_style_sheet(const LibraryFile& library, const std::vector<StyleGroup>& groups,
                              const std::string& path);

}  // namespace tessera
