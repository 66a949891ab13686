// Reads the closed contours of a DXF file, in mm.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "products/nesting/drawings/nest_contours.h"

namespace tessera {

struct DxfDrawings {
  std::vector<NestDrawing> drawings;  // NAME-1, NAME-2, ...
  std::vector<std::string> notes;     // what was left out or moved, for people: "left out 1 invisible entity"
  bool says_unit = false;             // $INSUNITS names a unit
  bool measures_in_inches = false;    // $MEASUREMENT is 0: a hint where no unit is named
};

/// Reads ASCII DXF, R12 or later: LWPOLYLINE, POLYLINE, LINE, ARC, CIRCLE, ELLIPSE and SPLINE of the model and of the
/// blocks that INSERT refers to. docs/nesting.md says what is left out. Lines, arcs and open polylines whose ends meet
/// within 0.01 mm are joined; repeated ones count once. $INSUNITS gives the unit; without it the unit is mm. A contour
/// inside another is a hole of it. A drawing far from the origin is moved there. Throws InputError that names `path` and
/// the line or contour.
DxfDrawings dxf_drawings(std::string_view text, const std::string& path, const std::string& name);

}  // namespace tessera
