// PNG, WebP and TIFF with transparency, and two-colour masks without (also BMP and JPEG), through OpenCV.
#pragma once

#include "io/artwork/artwork_page.h"

namespace tessera::io {

/// Decoded, 4 bytes a pixel: 200 MB.
inline constexpr double kMaxImagePixels = 50e6;

/// An image without transparency is a mask: the colour that prevails along its edge is the background, and what differs
/// from it by more than Otsu's threshold is the shape. Throws InputError where it is no image that we read, is damaged
/// or has more than kMaxImagePixels.
std::unique_ptr<ArtworkPage> open_raster_page(std::span<const std::uint8_t> bytes, const std::string& path);

}  // namespace tessera::io
