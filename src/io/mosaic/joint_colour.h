// What lies between the pieces of a mosaic.
#pragma once

#include <opencv2/core.hpp>

namespace tessera::io {

/// The mean of the light of a CV_8UC3 image (BGR, sRGB), half as bright. As bright as the mean, joints grey what is
/// dark, and outlines of light pieces are lost.
cv::Vec3b joint_colour(const cv::Mat& image_bgr);

}  // namespace tessera::io
