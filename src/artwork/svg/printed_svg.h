// A collage's SVG drawn for print: as librsvg draws it, but for what it gets wrong of pieces that are turned.
#pragma once

#include <cairo.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "artwork/svg/svg_document.h"
#include "artwork/svg/svg_pieces.h"

namespace tessera {

class PrintedSvg {
 public:
  /// `path` stands in messages. Any SVG will do; without `pieces_apart` it is drawn by librsvg alone. Throws InputError
  /// where it is none or is damaged; svg_page.h tells about hostile files.
  PrintedSvg(std::span<const std::uint8_t> svg, const std::string& path, bool pieces_apart = true);

  /// Of its page; only the ratio matters.
  cv::Size2d size() const { return ground_.size(); }
  /// Draws the page at (0, 0), `width_pt` points of 1/72 inch wide. Vectors stay vectors where the surface takes them.
  void draw(cairo_t* cairo, double width_pt) const;

 private:
  /// Points of a unit of the document, in x and y.
  cv::Size2d piece_scale(double width_pt) const;

  DividedSvg divided_;
  SvgDocument ground_;
  std::optional<SvgDocument> pieces_;  // where there are any
};

}  // namespace tessera
