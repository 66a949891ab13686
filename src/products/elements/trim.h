// Cuts regions that reach into the gap back to their own side of it.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

/// `lab`: smooth_lab(). Removes the rim of each region whose colour is nearer to that of its outermost pixels than to that
/// of its core, if the two differ.
cv::Mat trimmed_regions(const cv::Mat& labels, const cv::Mat& lab);

}  // namespace tessera
