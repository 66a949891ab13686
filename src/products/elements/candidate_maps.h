// Several ways to find elements in one picture.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "products/elements/segmentation/label_runs.h"

namespace tessera {

/// `bgr`: CV_8UC3, elements kElement_px wide. `lab`: smooth_lab(bgr). Gives the label maps of each way, in `size`; they
/// differ where the picture is hard. The larger the picture, the fewer ways are tried at a time: each takes some 40 bytes
/// a pixel while it lasts.
std::vector<LabelRuns> candidate_maps(const cv::Mat& bgr, const cv::Mat& lab, cv::Size size);

}  // namespace tessera
