// Divides a collage's SVG: what lies below the pieces, and each piece by itself, not turned.
#pragma once

#include <cairo.h>

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>
#include <string>
#include <vector>

namespace tessera {

/// A piece of collage.svg consists of several <use> elements (docs/result-format.md): its drawing, the tones over it, a
/// line along its outline. A SvgPiece is one of them. The overlay, which lies above the pieces, is the last in the
/// list.
struct SvgPiece {
  std::string id;
  cairo_matrix_t document_from_piece;
  cv::Size2d page;   // of the drawing's page, in units of the piece
  std::string clip;  // path data in these units, only lines, even-odd; empty: not clipped
};

struct DividedSvg {
  std::string ground;          // the document without its pieces and the overlay
  std::string pieces;          // the document with the unclipped pieces in their own units as px, without a page
  std::vector<SvgPiece> list;  // in the order of drawing
  cv::Size2d size;             // of the document, in its own units
};

/// Divides the document. Throws InputError where the bytes are no XML. A document without pieces is only a ground.
DividedSvg divided_svg(std::span<const std::uint8_t> svg, const std::string& path);

}  // namespace tessera
