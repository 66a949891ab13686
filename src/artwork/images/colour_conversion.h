// Colours as the world has them (sRGB of 8 bits, "#rrggbb") and as we compare them (CIELAB, D65).
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

#include "core/colour/lab.h"

namespace tessera {

/// `image`: BGR or BGRA of 8 bits. Lightness, a and b as CV_32FC3.
cv::Mat lab_image_of(const cv::Mat& image);

/// `bgr`: 0 to 255.
Lab lab_of(const cv::Vec3d& bgr);
cv::Vec3b bgr_of(const Lab& lab);

/// `hex`: "#rrggbb".
cv::Vec3b bgr_of(const std::string& hex);
std::string hex_of(const cv::Vec3b& bgr);

}  // namespace tessera
