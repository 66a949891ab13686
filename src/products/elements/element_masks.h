// Elements and gap told apart by brightness or colour: masks CV_8U, 0 or 255.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace tessera {

/// Levels of the grey by its local mean and deviation; the same number of masks for bright and for dark elements.
struct LevelMasks {
  std::vector<cv::Mat> bright, dark;
};
LevelMasks level_masks(const cv::Mat& bgr);

/// The colours of `lab` (smooth_lab()) in `colour_count` clusters; elements are those clusters that together make most
/// compact regions of a usual size.
cv::Mat colour_mask(const cv::Mat& lab, int colour_count);

}  // namespace tessera
