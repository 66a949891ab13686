// Regions that are a part of what lies between the elements.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

/// `labels` of elements in the picture `bgr` (CV_8UC3; `lab`: smooth_lab() of it) without those that are gap: their
/// colours and texture are the gap's rather than the elements', and no joint parts them from it. (A stone of the
/// mortar's colour has a joint around it.) All stay if there is next to no gap.
cv::Mat without_gap_regions(const cv::Mat& labels, const cv::Mat& bgr, const cv::Mat& lab);

}  // namespace tessera
