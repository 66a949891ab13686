// Reads an image with its background, to be laid under the pieces of a collage.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>
#include <string>

namespace tessera {

/// The image as straight BGRA, CV_8UC4, in its own px, turned as its EXIF data say; 16 bits a channel become 8. An
/// image of more than kMostWorkedPixels is reduced (reduced_picture.h). Throws InputError as decode_image does, and
/// where one of its sides is longer than `longest_side_px`.
cv::Mat whole_picture(std::span<const std::uint8_t> bytes, const std::string& path, int longest_side_px);

}  // namespace tessera
