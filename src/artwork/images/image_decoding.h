// Decodes untrusted pictures: PNG, WebP, TIFF, BMP and JPEG.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "artwork/images/formats/image_readers.h"

namespace tessera {

/// The largest picture that is decoded: it takes 200 MB with 4 bytes a pixel.
inline constexpr double kMaxImagePixels = 50e6;

/// Decodes the picture by the reader of its format. `path` stands in messages. Throws InputError where it is no picture
/// that we read, is damaged or ends early, or has more than kMaxImagePixels.
DecodedImage decode_image(std::span<const std::uint8_t> bytes, const std::string& path, PixelBits bits);

}  // namespace tessera
