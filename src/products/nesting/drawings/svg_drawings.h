// The closed shapes of an SVG, in mm.
//
// It is foreign: libxml2 parses it with its limits on depth and size, without network and entities, and loads nothing; what
// is read are numbers of attributes.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "products/nesting/drawings/nest_contours.h"

namespace tessera {

struct SvgDrawings {
  std::vector<NestDrawing> drawings;
  int open_paths = 0;                            // left out, as lines are
  int unread_elements = 0;                       // of other kinds, left out: use, image, text
  std::string left_out;                          // contours that are of no use (faults_text); empty: none
  bool says_unit = false;                        // width or height has a unit of length
  double page_width_mm = 0, page_height_mm = 0;  // 0: the file does not say how large its page is
};

/// Each path, rect, circle, ellipse, polygon or polyline that is no definition and not hidden, by its id or a number;
/// what lies inside of another, whatever element it is, is a hole of it. SVG's px are
/// 1/96 inch unless width, height and viewBox say otherwise. An outline of no use beside good ones is left out. Throws InputError, naming the file and
/// the element.
SvgDrawings svg_drawings(std::span<const std::uint8_t> bytes, const std::string& path);

}  // namespace tessera
