// A narrow margin of mortar between an element and the photo's edge, which labels of a coarse copy do not see.
#pragma once

#include <opencv2/core.hpp>

namespace tessera::io {

/// Takes from elements that reach the photo's edge what lies near it and is more like the gaps around them than like
/// their inside: those that the edge does not cut reach it no more. `photo_bgr`: CV_8UC3; `labels`: CV_32SC1 of its size,
/// as of element_labels, which stay connected.
cv::Mat without_margins(const cv::Mat& photo_bgr, const cv::Mat& labels);

}  // namespace tessera::io
