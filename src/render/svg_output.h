// Writes collage.svg: the artworks as vectors, each once, placed by transforms.
#pragma once

#include <functional>
#include <string>

#include "render/pieces/shape_artworks.h"
#include "result/collage_files.h"

namespace tessera {

/// Called after each shape, from any thread.
using DoneCount = std::function<void()>;

/// The text of the SVG. One unit is a canvas px; width and height are those of collage.png, or the physical size where the
/// job has one. Originals that are SVGs are copied as they are drawn (svg_import.h), bitmaps are embedded as PNG;
/// shape_artworks.h says how others are replaced. The file refers to nothing outside itself. Throws DrawingStopped.
std::string collage_svg(
    const CollageReport& report, ShapeArtworks& artworks, const DoneCount& done = [] {});

}  // namespace tessera
