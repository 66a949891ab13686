// Elements that touch, told apart by their outline alone.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

/// `mask`: CV_8U, what belongs to elements. Labels CV_32S: cut at its necks, where the distance to the gap falls below
/// three quarters of what it is within the smaller of both parts. Slivers are left out.
cv::Mat split_by_distance(const cv::Mat& mask);

}  // namespace tessera
