// The lines that a DXF draws: its entities, and those of the blocks that it refers to, where they are visible.
#pragma once

#include <string>
#include <vector>

#include "products/nesting/drawings/dxf_document.h"

namespace tessera {

struct DxfLines {
  std::vector<NestRing> lines;  // mm, y down; a closed one ends with its first point
  DxfTally hidden;              // entities on layers that are off or frozen, by layer
  int invisible = 0;            // entities that are invisible themselves
  DxfTally unread;              // entities of kinds that are not read
  DxfTally missing;             // references to blocks that the file does not hold
};

/// The result refers to the document's texts. Throws InputError that names `path` where a block contains itself, or there
/// are too many levels of blocks, entities or points.
DxfLines dxf_lines(const DxfDocument& document, const std::string& path);

}  // namespace tessera
