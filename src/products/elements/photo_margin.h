// A narrow margin of mortar between an element and the photo's edge, which labels of a coarse copy do not see.
#pragma once

#include <opencv2/core.hpp>

#include "products/elements/segmentation/label_runs.h"

namespace tessera {

/// Takes from elements that reach the photo's edge what lies near it and is more like the gaps around them than like
/// their inside: those that the edge does not cut reach it no more. `photo`: CV_8UC3 or CV_8UC4, BGR first; `labels`: of
/// its size, as of element_labels, which stay connected.
LabelRuns without_margins(const cv::Mat& photo, const LabelRuns& labels);

}  // namespace tessera
