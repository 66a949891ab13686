// Finds areas of a page's pixels: those connected to its edge, and those within some pixels.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

/// CV_8U, 255 where a pixel is connected to the edge of the page through pixels with 255 in `open` (CV_8U, 255 or 0).
/// Pixels are connected over their four sides.
cv::Mat connected_to_edge(const cv::Mat& open);

/// The square of all pixels within `radius_px` in x and in y, for cv::dilate and cv::erode.
cv::Mat square(int radius_px);

}  // namespace tessera
