// Decodes untrusted pictures: PNG, WebP, TIFF, BMP and JPEG.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "artwork/images/formats/image_readers.h"

namespace tessera {

/// Most pixels of a decoded picture: they take 200 MB with 4 bytes a pixel.
inline constexpr double kMaxImagePixels = 50e6;

/// Decodes the picture with the reader of its format. Orientation and colour profile are returned beside the pixels.
/// `path` is used in messages. Throws InputError where it is no picture that we read, is damaged or ends early, or has
/// more than kMaxImagePixels.
DecodedImage decode_image(std::span<const std::uint8_t> bytes, const std::string& path, PixelBits bits);

/// The pixels turned upright; their colours stay.
cv::Mat upright_pixels(const DecodedImage& image);

/// The picture as its maker saw it: upright and in sRGB. No other matrix may share the image's pixels.
cv::Mat seen_pixels(DecodedImage image);

}  // namespace tessera
