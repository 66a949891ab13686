// The files of one sheet of a layout.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "products/nesting/nest_result.h"

namespace tessera {

/// What is cut of one piece, where it lies: its outline, then its holes. mm, y down.
struct NestCut {
  int source = 0;
  std::string id;  // unique on the sheet, fit for XML
  std::vector<NestRing> contours;
  std::vector<PathSteps> curves;  // that the contours stand for; empty: it is a polygon
};

struct NestSheet {
  double width_mm = 0;
  double height_mm = 0;
  std::vector<NestCut> cuts;
};

NestSheet nest_sheet(const NestRun& run, int sheet);

/// One path a piece, in mm, with the curves of the input.
std::string sheet_svg(const NestSheet& sheet);
/// R12, mm, y up: one closed polyline a contour, curves as polygons.
std::string sheet_dxf(const NestSheet& sheet);
/// For people: pieces of one item in one colour.
std::vector<std::uint8_t> sheet_png(const NestSheet& sheet);

}  // namespace tessera
