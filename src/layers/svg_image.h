// A picture within an SVG document.
#pragma once

#include <opencv2/core.hpp>
#include <string>

namespace tessera {

/// Longest side of an embedded picture; larger ones are scaled down.
inline constexpr int kMaxBitmapSide_px = 2048;

/// The picture, scaled down to kMaxBitmapSide_px where it is larger.
cv::Mat in_embedded_size(const cv::Mat& picture);

/// An <image> element with this id that holds the straight BGRA picture as PNG. A pixel is one unit.
std::string svg_image(const cv::Mat& bgra, const std::string& id);

}  // namespace tessera
