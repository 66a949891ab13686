// The ground of a picture with several colours, on which it was drawn or photographed: the area connected to its edge.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

/// A pixel that differs from the ground's colour by at most this (of 255) may be noise of a JPEG.
inline constexpr double kGroundNoise = 24;

/// CV_8U, 255 where a pixel is connected to the edge through pixels near the ground's colour. `difference`: CV_8U,
/// difference of each pixel from that colour. A shadow on the ground belongs to the picture, as grey things have the
/// same colours.
cv::Mat ground_of(const cv::Mat& difference);

/// CV_8U: 0 on the ground and 255 elsewhere, except in a band of 2 px beside the ground. There it is the pixel's
/// difference divided by the largest one within 2 px, so that an antialiased edge keeps its sub-pixel place.
cv::Mat alpha_beside_ground(const cv::Mat& ground, const cv::Mat& difference);

}  // namespace tessera
