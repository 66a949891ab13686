// Separates elements from gaps by brightness or colour. Masks are CV_8U, 0 or 255.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace tessera {

/// Masks by the grey, relative to its local mean and deviation; as many for bright as for dark elements.
struct LevelMasks {
  std::vector<cv::Mat> bright, dark;
};
LevelMasks level_masks(const cv::Mat& bgr);

/// A mask by colour: divides the colours of `lab` (smooth_lab()) into `colour_count` clusters. Elements are the clusters
/// that together make most compact regions of a usual size.
cv::Mat colour_mask(const cv::Mat& lab, int colour_count);

}  // namespace tessera
