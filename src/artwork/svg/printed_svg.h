// Draws a collage's SVG for print with librsvg, and avoids librsvg's errors in turned pieces.
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
  /// Parses any SVG; without `pieces_apart` librsvg draws it alone. `path` is used in messages. Throws InputError where
  /// it is no SVG or is damaged; svg_page.h tells about hostile files.
  PrintedSvg(std::span<const std::uint8_t> svg, const std::string& path, bool pieces_apart = true);

  /// The size of its page; only the ratio matters.
  cv::Size2d size() const { return ground_.size(); }
  /// Draws the page at (0, 0), `width_pt` points of 1/72 inch wide. Vectors stay vectors where the surface supports
  /// them.
  void draw(cairo_t* cairo, double width_pt) const;

 private:
  /// Points for each unit of the document, in x and y.
  cv::Size2d piece_scale(double width_pt) const;

  DividedSvg divided_;
  SvgDocument ground_;
  std::optional<SvgDocument> pieces_;  // nullopt where there are none
};

}  // namespace tessera
