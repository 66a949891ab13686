// Decodes untrusted images: PNG, WebP, TIFF, BMP and JPEG, through OpenCV.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>
#include <string>

namespace tessera {

/// Decoded, 4 bytes a pixel: 200 MB.
inline constexpr double kMaxImagePixels = 50e6;

/// `flags`: as in cv::imdecode. Throws InputError where it is no image that we read, is damaged or has more than
/// kMaxImagePixels.
cv::Mat decode_image(std::span<const std::uint8_t> bytes, const std::string& path, int flags);

}  // namespace tessera
