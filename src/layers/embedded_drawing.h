// A foreign drawing as part of an SVG document: vectors where it can be copied as such, else its pixels.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>
#include <string>

#include "artwork/drawers/drawers.h"

namespace tessera {

struct EmbeddedDrawing {
  std::string svg;  // an element
  cv::Size2d size;  // of its page, in units of the element; the page's corner lies at (0, 0)
};

/// An element with this id. An SVG is copied (svg_import.h); where that cannot be, and of an image, it is a picture of
/// kMaxBitmapSide_px at most. Errors as Drawers::render.
EmbeddedDrawing embedded_drawing(std::span<const std::uint8_t> bytes, const std::string& path, const std::string& id,
                                 Drawers& drawers);

}  // namespace tessera
