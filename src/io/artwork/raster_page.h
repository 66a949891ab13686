// PNG, WebP and TIFF with transparency, and two-colour masks without (also BMP and JPEG), through OpenCV.
#pragma once

#include "io/artwork/artwork_page.h"

namespace tessera::io {

/// An image without transparency is a mask: the colour that prevails along its edge is the background, and what differs
/// from it by more than Otsu's threshold is the shape. Throws InputError where it is no image that we read, is damaged,
/// has more than kMaxImagePixels (image_decoding.h), or is a photo that fills its frame.
std::unique_ptr<ArtworkPage> open_raster_page(std::span<const std::uint8_t> bytes, const std::string& path);

}  // namespace tessera::io
