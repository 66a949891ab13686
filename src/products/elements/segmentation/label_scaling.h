// Labels of a working copy brought to the photo's size.
#pragma once

#include <opencv2/core.hpp>

#include "products/elements/segmentation/label_runs.h"

namespace tessera {

/// Each region is scaled by itself with a smooth outline; where two would overlap, the one that is there stays. Every
/// region is solid (region_labels.h). Takes about a byte for a pixel of `size`.
LabelRuns scaled_labels(const cv::Mat& labels, cv::Size size);

}  // namespace tessera
