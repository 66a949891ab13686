// An ASCII DXF, R12 or later, read as far as it is of use: the sections HEADER, TABLES, BLOCKS and ENTITIES.
#pragma once

#include <string>
#include <string_view>

#include "products/nesting/drawings/dxf_document.h"

namespace tessera {

/// `text` lives longer than the document. Throws InputError, naming `path` and the line, where the file is no ASCII DXF,
/// or has too many points, layers or blocks.
DxfDocument dxf_document(std::string_view text, const std::string& path);

}  // namespace tessera
