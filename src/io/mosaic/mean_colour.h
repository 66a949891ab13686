// One colour for a whole image.
#pragma once

#include <opencv2/core.hpp>
#include <string>

namespace tessera::io {

/// "#rrggbb": the mean of the light of a CV_8UC3 image (BGR, sRGB), as eyes see it from far away.
std::string mean_colour(const cv::Mat& image_bgr);

}  // namespace tessera::io
