// A foreign drawing as part of an SVG document: as vectors where it can be copied, else as pixels.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>
#include <string>

#include "artwork/drawers/drawers.h"

namespace tessera {

struct EmbeddedDrawing {
  std::string svg;  // an SVG element
  cv::Size2d size;  // of the drawing's page, in units of the element; the page's corner is at (0, 0)
};

/// The drawing as an element with this id. An SVG is copied (svg_import.h); an SVG that cannot be copied, or an image,
/// becomes a picture of at most kMaxBitmapSide_px. Throws the errors of Drawers::render.
EmbeddedDrawing embedded_drawing(std::span<const std::uint8_t> bytes, const std::string& path, const std::string& id,
                                 Drawers& drawers);

}  // namespace tessera
