// The pieces that a texture begins with: a layout in the shapes of a library.
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "core/shape/shape.h"
#include "products/texture/texture_layout.h"

namespace tessera {

/// A shape of the library, and the element of the photo that it is.
struct ElementShape {
  Shape shape;  // with outline and artwork
  PhotoElement element;
};

/// The text of the file for start.pieces. `layout`: of these elements. `canvas_px` repeats both ways.
std::string texture_pieces(const std::vector<LaidElement>& layout, const std::vector<ElementShape>& elements,
                           cv::Size canvas_px);

}  // namespace tessera
