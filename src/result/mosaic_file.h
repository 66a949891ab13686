// Measures a mosaic of any origin, a picture in a file, against the picture that it shows.
#pragma once

#include <cstddef>
#include <string>

#include "core/field/canvas.h"
#include "result/afar_section.h"

namespace tessera {

/// The image that a mosaic is compared with.
struct ShownImage {
  std::string path;             // an SVG or an image
  const char* key = "--image";  // messages begin with it
};

/// `pieces`: the number of pieces in the mosaic; 0: unknown, and at_piece_size is missing. The image is stretched over the
/// mosaic, whose aspect may differ by 5 %, because makers of mosaics round to whole tiles. The mosaic must be at least 100
/// px wide. It is read by Drawers::whole_picture: at most 8192 px each way and 50 million px. Throws InputError that says
/// what was found and what is allowed, EnvironmentError.
SeenFromAfar mosaic_from_afar(const std::string& mosaic, const ShownImage& image, std::size_t pieces);

/// A mosaic on a canvas as it is seen from afar. Only the area of the canvas counts, and the image covers it like
/// colour.image. The aspect of the mosaic may differ from the canvas' by 5 %, and it may be less than 100 px wide.
SeenFromAfar mosaic_from_afar(const std::string& mosaic, const ShownImage& image, const Canvas& canvas,
                              std::size_t pieces);

/// Whether the file begins like a PNG, JPEG, WebP, TIFF or BMP. False where it cannot be read.
bool looks_like_picture(const std::string& path);

}  // namespace tessera
