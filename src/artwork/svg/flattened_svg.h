// An SVG as cairo writes it when librsvg draws it: style sheets, text, markers, symbols and units are gone, and what is
// left is paths, gradients, patterns, clips, masks, bitmaps and groups that are used.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>
#include <string>

namespace tessera {

/// The longest side of the page in units of a flattened drawing, and in px of what librsvg draws as pixels: filters and
/// masks. cairo rounds coordinates to 1/256 unit.
inline constexpr double kFlattenedSide = 1024;

struct FlattenedSvg {
  std::string text;
  cv::Size2d page;            // in units of its own, as ArtworkPage::natural_size
  double page_from_unit = 1;  // how large a unit is on the page
};

/// Throws InputError where the bytes are no SVG or SVGZ, break a limit (svg_page.h) or become too large. Takes as much
/// time and memory as drawing them does.
FlattenedSvg flattened_svg(std::span<const std::uint8_t> bytes, const std::string& path);

}  // namespace tessera
