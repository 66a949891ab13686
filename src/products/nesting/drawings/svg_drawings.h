// Reads the closed shapes of an SVG, in mm.
#pragma once

#include <string>
#include <vector>

#include "artwork/outlines/svg_outlines.h"
#include "products/nesting/drawings/nest_contours.h"

namespace tessera {

struct SvgDrawings {
  std::vector<NestDrawing> drawings;
  /// Notes for people about what was left out or joined: "left out 1 chain of lines that does not close".
  std::vector<std::string> notes;
};

/// The largest distance of ends of two open paths that are joined, mm.
inline constexpr double kJoinedEnds_mm = 0.05;

/// The pieces of an SVG: its fills, and its lines that are closed or close each other. They have the names of their
/// elements; elements named in `left_out` are not cut. A contour inside another, of any element, is a hole of it. Unusable
/// outlines are left out if others are good. Throws InputError that names `path`.
SvgDrawings svg_drawings(const SvgOutlines& outlines, const std::string& path,
                         const std::vector<std::string>& left_out = {});

}  // namespace tessera
