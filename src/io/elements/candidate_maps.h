// Several ways to find elements in one picture.
#pragma once

#include <functional>
#include <opencv2/core.hpp>
#include <vector>

namespace tessera::io {

/// `bgr`: CV_8UC3, elements kElement_px wide. One label map for each way; they differ where the picture is hard.
/// `lab`: smooth_lab(bgr). `look` is called before each way, from several threads, and may throw.
std::vector<cv::Mat> candidate_maps(const cv::Mat& bgr, const cv::Mat& lab, const std::function<void()>& look);

}  // namespace tessera::io
