// The closed shapes of an SVG, in mm.
#pragma once

#include <string>
#include <vector>

#include "artwork/outlines/svg_outlines.h"
#include "products/nesting/drawings/nest_contours.h"

namespace tessera {

struct SvgDrawings {
  std::vector<NestDrawing> drawings;
  std::vector<std::string>
      notes;  // what was left out or joined, for people: "left out 1 open path: it encloses nothing"
};

/// How far apart the ends of two open paths may be that are joined, mm.
inline constexpr double kJoinedEnds_mm = 0.05;

/// What is filled, and lines that are closed or close each other, by the names of their elements; those called
/// `left_out` are not cut. What lies inside of another, whatever element it is, is a hole of it. An outline of no use
/// beside good ones is left out. `path` stands in messages. Throws InputError, naming it.
SvgDrawings svg_drawings(const SvgOutlines& outlines, const std::string& path,
                         const std::vector<std::string>& left_out = {});

}  // namespace tessera
