// Decodes untrusted pictures: PNG, WebP, TIFF, BMP and JPEG.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "artwork/images/formats/image_readers.h"

namespace tessera {

/// Decoded, 4 bytes a pixel: 200 MB.
inline constexpr double kMaxImagePixels = 50e6;

/// Throws InputError where it is no picture that we read, is damaged or ends early, or has more than kMaxImagePixels.
DecodedImage decode_image(std::span<const std::uint8_t> bytes, const std::string& path, PixelBits bits);

}  // namespace tessera
