// Repairs label maps from other programs.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

/// Smaller regions, in pixels, are specks.
inline constexpr int kLeastRegion_px2 = 64;

/// A new label map, CV_32SC1. Each region that one value above 0 fills, connected by sides of pixels, gets a label of its
/// own, 1..n in the order of their uppermost rows; specks become gap. So a number that is used twice, or is scattered over
/// the photo, does not make one element as large as the photo.
cv::Mat connected_labels(const cv::Mat& labels);

}  // namespace tessera
