// The outlines of an SVG's elements in mm, with their ids, for cutting. librsvg applies everything that a browser would
// (style sheets, units, nested viewports, <use>, clips), and cairo writes the paths.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>
#include <string>
#include <vector>

#include "artwork/svg/path_steps.h"
#include "artwork/svg/svg_page.h"

namespace tessera {

/// One painted path: the contours of a fill, or the centre line of a stroke. The stroke of an element that is also
/// filled is not listed.
struct SvgOutline {
  std::string name;       // the element's id; without one, its kind and its number in the file
  bool filled = false;    // false: a line
  bool even_odd = false;  // the fill rule
  /// Coordinates in mm from the page's upper left corner, y down. Rounded to 1e-4, or to 1e-3 in a drawing of more than
  /// 50 m.
  PathSteps steps;
};

struct SvgOutlines {
  std::vector<SvgOutline> outlines = {};  // in the order of the file
  int unread_elements = 0;                // visible texts, images and foreign objects
  /// The names of elements that are hidden, transparent, damaged, without fill and stroke, or without a size.
  std::vector<std::string> undrawn_elements = {};
  /// The names of elements that a mask hides partly: their outlines ignore the mask.
  std::vector<std::string> masked_elements = {};
  std::vector<std::string> far_elements = {};  // names of elements that reach too far; they are left out
  bool says_unit = false;                      // width or height has a unit of length
  cv::Size2d page_mm = {};                     // empty: the file does not state the size of its page
  std::string program = {};                    // the program that wrote the file, "Inkscape 0.48.4"; empty: unknown
  double program_px_per_inch = 0;              // px in an inch of that program; 0: CSS's, unknown, or irrelevant
};

/// The outlines of all elements. Masks are removed; filters, markers and dashes are ignored; opacity matters only where
/// it is 0. `px_per_inch`: size of the file's px. It takes as long as drawing the SVG, plus a time that grows with the
/// square of the number of its elements. Throws InputError, which names `path`, where the bytes are no SVG or SVGZ, or
/// exceed a limit (below, and svg_page.h).
SvgOutlines svg_outlines(std::span<const std::uint8_t> bytes, const std::string& path,
                         double px_per_inch = kCssPxPerInch);

/// Most elements that draw something, and most steps of all paths together.
inline constexpr std::size_t kMostOutlineElements = 10'000;
inline constexpr std::size_t kMostOutlineSteps = 400'000;
/// Largest distance of an outline from the page's corner, mm.
inline constexpr double kFarthestOutline_mm = 1e6;

}  // namespace tessera
