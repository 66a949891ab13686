// Areas of a page's pixels: what is connected to its edge, and what lies within some pixels.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

/// CV_8U, 255 where a pixel is connected to the edge of the page over pixels of `open` that are 255 (CV_8U, 255 or 0).
/// Pixels are connected over their four sides.
cv::Mat connected_to_edge(const cv::Mat& open);

/// The square of all pixels within `radius_px` in x and in y, for cv::dilate and cv::erode.
cv::Mat square(int radius_px);

}  // namespace tessera
