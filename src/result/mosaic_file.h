// Anybody's mosaic, a picture in a file, measured against the picture that it shows.
#pragma once

#include <cstddef>
#include <string>

#include "core/field/canvas.h"
#include "result/afar_section.h"

namespace tessera {

/// What a mosaic is held against.
struct ShownImage {
  std::string path;             // an SVG or an image
  const char* key = "--image";  // messages begin with it
};

/// `pieces`: how many the mosaic has; 0: nobody says, and at_piece_size is missing. The image is stretched over the
/// mosaic, which has its aspect to 5 %: makers of mosaics round to whole tiles. The mosaic is 100 px wide or more and
/// as Drawers::whole_picture reads it: 8192 px each way and 50 million px at most. Throws InputError that says what was
/// found and what is allowed, EnvironmentError.
SeenFromAfar mosaic_from_afar(const std::string& mosaic, const ShownImage& image, std::size_t pieces);

/// The same on a canvas: only what lies on it counts, and the image covers it as colour.image does. The mosaic has the
/// canvas' aspect to 5 %, and may be less than 100 px wide.
SeenFromAfar mosaic_from_afar(const std::string& mosaic, const ShownImage& image, const Canvas& canvas,
                              std::size_t pieces);

/// Whether a file begins as a PNG, JPEG, WebP, TIFF or BMP does. False where it cannot be read.
bool looks_like_picture(const std::string& path);

}  // namespace tessera
