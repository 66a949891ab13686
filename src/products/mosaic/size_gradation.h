// Makes sizes change gently from place to place.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

/// `sizes`: CV_32F. Lowers them to the largest map that is nowhere above them and grows by at most `slope` for each px of
/// the map. So large pieces keep away from small ones. Distances are those of a chamfer mask (5, 7).
void limit_growth(cv::Mat& sizes, float slope);

}  // namespace tessera
