// Scales the labels of a working copy to the photo's size.
#pragma once

#include <opencv2/core.hpp>

#include "products/elements/segmentation/label_runs.h"

namespace tessera {

/// Each region is scaled by itself with a smooth outline. Where two would overlap, the earlier one stays. Every region is
/// solid (region_labels.h). It takes about a byte for each pixel of `size`.
LabelRuns scaled_labels(const cv::Mat& labels, cv::Size size);

}  // namespace tessera
