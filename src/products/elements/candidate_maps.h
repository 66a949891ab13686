// Finds elements in one picture in several ways, each of which gives maps of labels.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "products/elements/segmentation/label_runs.h"

namespace tessera {

/// `bgr`: CV_8UC3, with elements kElement_px wide. `lab`: smooth_lab(bgr). Returns the label maps of all ways, in `size`;
/// they differ where the picture is hard. For a larger picture fewer ways run at a time, because each takes some 40 bytes a
/// pixel.
std::vector<LabelRuns> candidate_maps(const cv::Mat& bgr, const cv::Mat& lab, cv::Size size);

}  // namespace tessera
