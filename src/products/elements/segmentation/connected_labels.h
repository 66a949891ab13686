// Labels from another program, made fit for use.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

/// Pixels of a region below which it is a speck.
inline constexpr int kLeastRegion_px2 = 64;

/// CV_32SC1 again: each region that one value above 0 fills, connected by its pixels' sides, has a label of its own, 1..n
/// in the order of their uppermost rows; specks are gap. So neither a number that is used twice nor one that is
/// scattered all over the photo makes an element as large as the photo.
cv::Mat connected_labels(const cv::Mat& labels);

}  // namespace tessera
