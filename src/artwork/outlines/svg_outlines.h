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

/// One path as it is painted. Of an element that is filled only what is filled is listed; of one that has but a stroke
/// the stroke's centre line.
struct SvgOutline {
  std::string name;       // the element's id; of one without, its kind and its number in the file
  bool filled = false;    // else a line
  bool even_odd = false;  // the rule by which it is filled
  PathSteps
      steps;  // mm from the page's upper left corner, y down; rounded to 1e-4, or to 1e-3 where the drawing is larger than 50 m
};

struct SvgOutlines {
  std::vector<SvgOutline> outlines = {};  // in the order of the file
  int unread_elements = 0;                // text, images and foreign objects that are drawn, and are no outlines
  std::vector<std::string> undrawn_elements =
      {};  // names of those that are hidden, transparent, without fill and stroke, or without a size
  std::vector<std::string> far_elements = {};  // names of those that reach too far, and are left out
  bool says_unit = false;                      // width or height has a unit of length, which px are not
  cv::Size2d page_mm = {};                     // empty: the file does not say how large its page is
  std::string program = {};                    // that wrote the file, "Inkscape 0.48.4"; empty: none that is known
  double program_px_per_inch = 0;              // where that is not CSS's, and sizes depend on it; else 0
};

/// Filters, masks, markers and dashes are not looked at, and opacity only where it is 0. `px_per_inch`: how large the
/// file's px are. Takes as much time as drawing the SVG, and more with the square of its elements. Throws InputError,
/// naming `path`, where the bytes are no SVG or SVGZ, or break a limit (svg_page.h and below).
SvgOutlines svg_outlines(std::span<const std::uint8_t> bytes, const std::string& path,
                         double px_per_inch = kCssPxPerInch);

/// Elements that may draw something, and steps of all paths.
inline constexpr std::size_t kMostOutlineElements = 10'000;
inline constexpr std::size_t kMostOutlineSteps = 400'000;
/// How far from the page's corner an outline may reach, mm.
inline constexpr double kFarthestOutline_mm = 1e6;

}  // namespace tessera
