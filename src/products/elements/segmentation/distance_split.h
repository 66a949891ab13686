// Separates touching elements by their outline only.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

/// `mask`: CV_8U, the pixels of elements. Returns labels, CV_32S: the mask is cut at its necks, where the distance to the
/// gap is less than three quarters of the distance inside the smaller part. Slivers are left out.
cv::Mat split_by_distance(const cv::Mat& mask);

}  // namespace tessera
