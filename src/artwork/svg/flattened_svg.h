// An SVG as cairo writes it when librsvg draws it. Style sheets, text, markers, symbols and units are gone; paths,
// gradients, patterns, clips, masks, bitmaps and groups remain.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>
#include <string>

namespace tessera {

/// Longest side of the page in units of a flattened drawing, and in px of the parts that librsvg draws as pixels
/// (filters and masks). cairo rounds coordinates to 1/256 unit.
inline constexpr double kFlattenedSide = 1024;

struct FlattenedSvg {
  std::string text;
  cv::Size2d page;            // in its own units, as ArtworkPage::natural_size
  double page_from_unit = 1;  // size of a unit on the page
};

/// Flattens an SVG. Throws InputError where the bytes are no SVG or SVGZ, exceed a limit (svg_page.h) or become too
/// large. Takes as much time and memory as drawing it.
FlattenedSvg flattened_svg(std::span<const std::uint8_t> bytes, const std::string& path);

}  // namespace tessera
