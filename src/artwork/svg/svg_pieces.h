// A collage's SVG taken apart: what lies below the pieces, and each piece by itself, not turned.
#pragma once

#include <cairo.h>

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>
#include <string>
#include <vector>

namespace tessera {

/// A piece of collage.svg consists of several <use> elements (docs/result-format.md): its drawing, the tones over it, a
/// line along its outline. This is one of them. The overlay, which lies above the pieces, is the last one of a list.
struct SvgPiece {
  std::string id;
  cairo_matrix_t document_from_piece;
  cv::Size2d page;   // of the drawing, in units of the piece
  std::string clip;  // data of a path in these units, lines only, even-odd; empty: not clipped
};

struct DividedSvg {
  std::string ground;  // the document without its pieces and the overlay
  std::string pieces;  // the document with the pieces unclipped, where their own units are px, and without a page
  std::vector<SvgPiece> list;  // in the order in which they are drawn
  cv::Size2d size;             // of the document, in its own units
};

/// Throws InputError where the bytes are no XML. A document without pieces comes back as its own ground.
DividedSvg divided_svg(std::span<const std::uint8_t> svg, const std::string& path);

}  // namespace tessera
