// The closed shapes of an SVG, in mm.
#pragma once

#include <string>
#include <vector>

#include "artwork/outlines/svg_outlines.h"
#include "products/nesting/drawings/nest_contours.h"

namespace tessera {

struct SvgDrawings {
  std::vector<NestDrawing> drawings;
  /// What was left out or joined, for people: "left out 1 chain of lines that does not close".
  std::vector<std::string> notes;
};

/// How far apart the ends of two open paths may be that are joined, mm.
inline constexpr double kJoinedEnds_mm = 0.05;

/// The pieces of an SVG: its fills, and its lines that are closed or close each other. They have the names of their
/// elements; elements called `left_out` are not cut. A contour that lies inside another, of whatever element, is a hole of
/// it. Where some outlines are good, bad ones are left out. `path` stands in messages. Throws InputError, naming it.
SvgDrawings svg_drawings(const SvgOutlines& outlines, const std::string& path,
                         const std::vector<std::string>& left_out = {});

}  // namespace tessera
