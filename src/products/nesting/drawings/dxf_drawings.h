// The closed contours of a DXF file, in mm.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "products/nesting/drawings/nest_contours.h"

namespace tessera {

struct DxfDrawings {
  std::vector<NestDrawing> drawings;  // NAME-1, NAME-2, ...
  int open_chains = 0;                // left out, as are those that enclose nothing
  int unread_entities = 0;            // of other kinds, left out: splines, blocks, texts
  bool says_unit = false;             // $INSUNITS names one
};

/// ASCII DXF, R12 or later: LWPOLYLINE, POLYLINE, LINE, ARC and CIRCLE of the model. Lines, arcs and open polylines whose
/// ends meet within 0.01 mm are joined, what is there twice counts once. $INSUNITS says the unit; without one it is mm. A contour inside another is a hole
/// of it. Throws InputError, naming `path` and the line.
DxfDrawings dxf_drawings(std::string_view text, const std::string& path, const std::string& name);

}  // namespace tessera
