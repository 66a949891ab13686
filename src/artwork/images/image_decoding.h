// Decodes untrusted pictures: PNG, WebP, TIFF, BMP and JPEG.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "artwork/images/formats/image_readers.h"

namespace tessera {

/// The largest picture that is decoded: it takes 200 MB with 4 bytes a pixel.
inline constexpr double kMaxImagePixels = 50e6;

/// Decodes the picture by the reader of its format; how it is to be turned, and what its colours
/// are, is told beside the pixels. `path` stands in messages. Throws InputError where it is no picture
/// that we read, is damaged or ends early, or has more than kMaxImagePixels.
DecodedImage decode_image(std::span<const std::uint8_t> bytes, const std::string& path, PixelBits bits);

/// The pixels as they were seen; their colours stay.
cv::Mat upright_pixels(const DecodedImage& image);

/// The picture as its maker saw it: turned, and in sRGB. Nothing else may look at the image's pixels.
cv::Mat seen_pixels(DecodedImage image);

}  // namespace tessera
