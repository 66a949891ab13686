// The ground that a picture of several colours was drawn or photographed on: what its edge is connected to.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

/// Below this difference (of 255) from the ground's colour a pixel may be noise of a JPEG.
inline constexpr double kGroundNoise = 24;

/// CV_8U, 255 where the edge is reached over pixels near the ground's colour. `difference`: CV_8U, how far each pixel is
/// from that colour. A shadow on the ground belongs to the picture: grey things have the same colours.
cv::Mat ground_of(const cv::Mat& difference);

/// CV_8U: 0 on the ground, 255 elsewhere but for a band of 2 px beside the ground. There it is the pixel's difference as
/// part of the largest one within 2 px, so that an antialiased edge keeps its sub-pixel place.
cv::Mat alpha_beside_ground(const cv::Mat& ground, const cv::Mat& difference);

}  // namespace tessera
