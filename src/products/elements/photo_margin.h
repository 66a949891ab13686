// Removes a narrow margin of mortar between an element and the photo's edge, which labels of a coarse copy do not show.
#pragma once

#include <opencv2/core.hpp>

#include "products/elements/segmentation/label_runs.h"

namespace tessera {

/// Takes from elements at the photo's edge the pixels near the edge that are more like the gaps around them than like their
/// inside. Elements that the edge does not cut then no longer reach it. `photo`: CV_8UC3 or CV_8UC4, BGR first. `labels`:
/// of its size, from element_labels(); they stay connected.
LabelRuns without_margins(const cv::Mat& photo, const LabelRuns& labels);

}  // namespace tessera
