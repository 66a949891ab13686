// Removes regions that are a part of the gap between the elements.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

/// The `labels` of elements in the picture `bgr` (CV_8UC3; `lab`: smooth_lab() of it) without regions that are gap: their
/// colours and texture are the gap's rather than the elements', and no joint separates them from the gap. (A stone with the
/// mortar's colour has a joint around it.) All regions stay if there is hardly any gap.
cv::Mat without_gap_regions(const cv::Mat& labels, const cv::Mat& bgr, const cv::Mat& lab);

}  // namespace tessera
