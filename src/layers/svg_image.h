// A picture within an SVG document.
#pragma once

#include <opencv2/core.hpp>
#include <string>

namespace tessera {

/// The longest side of pictures that are embedded; larger ones are scaled down.
inline constexpr int kMaxBitmapSide_px = 2048;

/// An <image> with this id, a unit a pixel, that holds the straight BGRA as PNG.
std::string svg_image(const cv::Mat& bgra, const std::string& id);

}  // namespace tessera
