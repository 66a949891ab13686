// Reads the useful sections of an ASCII DXF, R12 or later: HEADER, TABLES, BLOCKS and ENTITIES.
#pragma once

#include <string>
#include <string_view>

#include "products/nesting/drawings/dxf_document.h"

namespace tessera {

/// `text` must outlive the document. Throws InputError that names `path` and the line where the file is no ASCII DXF, or
/// has too many points, layers or blocks.
DxfDocument dxf_document(std::string_view text, const std::string& path);

}  // namespace tessera
