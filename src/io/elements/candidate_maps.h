// Several ways to find elements in one picture.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace tessera::io {

/// `bgr`: CV_8UC3, elements kElement_px wide. One label map for each way; they differ where the picture is hard.
/// `lab`: smooth_lab(bgr).
std::vector<cv::Mat> candidate_maps(const cv::Mat& bgr, const cv::Mat& lab);

}  // namespace tessera::io
