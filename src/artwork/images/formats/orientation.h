// How a camera was held, as EXIF data and TIFFs say it by a number of 1 (upright) to 8.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>

namespace tessera {

/// `exif`: from its byte order mark ("II" or "MM") on. 1 where nothing is said, or nothing that is known.
int exif_orientation(std::span<const std::uint8_t> exif);

/// Finds the EXIF data of a JPEG, PNG or WebP without a decoder, and reads the orientation there. `bytes`: the whole file.
/// 1 for all other bytes, and for TIFF, whose reader looks itself.
int orientation_in_file(std::span<const std::uint8_t> bytes);

/// `picture` as it was seen: mirrored and turned as `orientation` says. What is upright is not copied.
cv::Mat turned_upright(const cv::Mat& picture, int orientation);

}  // namespace tessera
