// Converts an SVG to a PDF file.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tessera {

/// A PDF with one page, `width_pt` points of 1/72 inch wide; vectors stay vectors. It has no time stamp: the same SVG
/// gives the same bytes. `pieces_apart`: draws as printed_svg.h does; otherwise librsvg alone draws the page. See
/// svg_page.h about hostile files. Throws InputError where it is no SVG, is damaged or cannot be drawn.
std::vector<std::uint8_t> pdf_of_svg(std::span<const std::uint8_t> svg, const std::string& path, double width_pt,
                                     bool pieces_apart);

}  // namespace tessera
