// Converts colours between sRGB (8 bits, "#rrggbb") and CIELAB (D65), in which colours are compared.
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

#include "core/colour/lab.h"

namespace tessera {

/// Lightness, a and b as CV_32FC3. `image`: BGR or BGRA of 8 bits.
cv::Mat lab_image_of(const cv::Mat& image);

/// The colour in CIELAB. `bgr`: 0 to 255.
Lab lab_of(const cv::Vec3d& bgr);
cv::Vec3b bgr_of(const Lab& lab);

/// The colour of "#rrggbb".
cv::Vec3b bgr_of(const std::string& hex);
std::string hex_of(const cv::Vec3b& bgr);

}  // namespace tessera
