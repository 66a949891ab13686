// Reads a PNG unchanged: a thumbnail of a library, a finished collage. Artwork is read by raster_page.h, which cuts
// shapes out.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>
#include <string>

namespace tessera {

/// The image, reduced where a side is longer than `longest_side_px`; a new pixel is the mean of its area, weighted by
/// alpha. `image` has 8 bits and 1, 3 or 4 channels (straight BGRA).
cv::Mat shrunk(const cv::Mat& image, int longest_side_px);

/// The picture as straight BGRA, CV_8UC4; shrunk where it is larger than `longest_side_px`. Throws InputError where it
/// is no PNG or is damaged.
cv::Mat png_picture(std::span<const std::uint8_t> bytes, const std::string& path, int longest_side_px);

}  // namespace tessera
