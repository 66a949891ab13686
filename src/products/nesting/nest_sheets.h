// Writes the files of one sheet of a layout.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "products/nesting/nest_result.h"

namespace tessera {

/// The lines that are cut for one piece, in its place: its outline, then its holes. mm, y down.
struct NestCut {
  int source = 0;
  std::string id;  // unique on the sheet, valid in XML
  std::vector<NestRing> contours;
  std::vector<PathSteps> curves;  // the curves of the contours; empty: it is a polygon
};

struct NestSheet {
  double width_mm = 0;
  double height_mm = 0;
  std::vector<NestCut> cuts;
};

NestSheet nest_sheet(const NestRun& run, int sheet);

/// An SVG with one path for each piece, in mm, with the curves of the input.
std::string sheet_svg(const NestSheet& sheet);
/// A DXF R12, mm, y up: one closed polyline for each contour, with curves as polygons.
std::string sheet_dxf(const NestSheet& sheet);
/// A picture for people: pieces of one item have one colour.
std::vector<std::uint8_t> sheet_png(const NestSheet& sheet);

}  // namespace tessera
