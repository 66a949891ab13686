// collage.svg: the artworks as vectors, each once, placed by transforms.
#pragma once

#include <string>

#include "io/result/collage_files.h"

namespace tessera::io {

/// One unit is a canvas px; width and height are those of collage.png. Originals that are SVGs are taken over as they are
/// drawn (svg_import.h), bitmaps are embedded as PNG; where the original is gone or unreadable the thumbnail stands in,
/// and where there is none the outline in the shape's mean colour. The file refers to nothing outside itself.
/// `quick` uses thumbnails throughout.
std::string collage_svg(const CollageReport& report, bool quick);

}  // namespace tessera::io
