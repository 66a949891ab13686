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

/// The colours for colour_mask(), CV_32FC3: those of `lab` (smooth_lab()), with a lightness that is relative to its
/// surroundings.
cv::Mat relative_colours(const cv::Mat& lab);

/// A mask by colour: divides the `colours` (relative_colours()) into `colour_count` clusters. Elements are the clusters
/// that together make most compact regions of a usual size.
cv::Mat colour_mask(const cv::Mat& colours, int colour_count);

}  // namespace tessera
