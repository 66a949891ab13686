// An image with all that it shows, nothing cut out of a background: what is laid under the pieces of a collage.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>
#include <string>

namespace tessera {

/// Straight BGRA, CV_8UC4, in its own px; 16 bits a channel become 8, and it is turned as its EXIF data say. One of more than kMostWorkedPixels is reduced (reduced_picture.h). Throws InputError as decode_image does, and where
/// one of its sides is longer than `longest_side_px`.
cv::Mat whole_picture(std::span<const std::uint8_t> bytes, const std::string& path, int longest_side_px);

}  // namespace tessera
