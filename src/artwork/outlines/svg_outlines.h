// The outlines of an SVG's elements in mm, under their ids: what is cut. librsvg applies everything that a browser
// would (style sheets, units, nested viewports, <use>, clips), and cairo writes the paths down.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>
#include <string>
#include <vector>

#include "artwork/svg/path_steps.h"
#include "artwork/svg/svg_page.h"

namespace tessera {

/// One path as it is painted: the contours of a fill, or the centre line of a stroke. The stroke of an element that is
/// filled, too, is not listed.
struct SvgOutline {
  std::string name;       // the element's id; of one without, its kind and its number in the file
  bool filled = false;    // else a line
  bool even_odd = false;  // the rule by which it is filled
  /// In mm from the page's upper left corner, y down. Rounded to 1e-4, or to 1e-3 in a drawing of more than 50 m.
  PathSteps steps;
};

struct SvgOutlines {
  std::vector<SvgOutline> outlines = {};  // in the order of the file
  int unread_elements = 0;                // texts, images and foreign objects that are drawn
  /// The names of elements that are hidden, transparent, damaged, without fill and stroke, or without a size.
  std::vector<std::string> undrawn_elements = {};
  /// The names of elements of which a mask hides part: their outlines are those without it.
  std::vector<std::string> masked_elements = {};
  std::vector<std::string> far_elements = {};  // the names of elements that reach too far, and are left out
  bool says_unit = false;                      // width or height names a unit of length
  cv::Size2d page_mm = {};                     // empty: the file does not say how large its page is
  std::string program = {};                    // the program that wrote the file, "Inkscape 0.48.4"; empty: not known
  double program_px_per_inch = 0;  // px of an inch for that program; 0: CSS's, not known, or no size depends on it
};

/// The outlines of all elements. Masks are taken off; filters, markers and dashes are not looked at, and opacity only where it is 0.
/// `px_per_inch` says how large the file's px are. Takes as much time as drawing the SVG, and more with the square of the
/// number of its elements. Throws InputError, naming `path`, where the bytes are no SVG or SVGZ, or break a limit (below, and
/// svg_page.h).
SvgOutlines svg_outlines(std::span<const std::uint8_t> bytes, const std::string& path,
                         double px_per_inch = kCssPxPerInch);

/// How many elements may draw something, and how many steps all paths may have.
inline constexpr std::size_t kMostOutlineElements = 10'000;
inline constexpr std::size_t kMostOutlineSteps = 400'000;
/// How far from the page's corner an outline may reach, mm.
inline constexpr double kFarthestOutline_mm = 1e6;

}  // namespace tessera
