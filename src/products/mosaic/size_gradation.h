// Sizes that change gently from place to place.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

/// `sizes`: CV_32F. Lowers them to the greatest map that nowhere is above it and grows by `slope` a px of the map at
/// most, so that something large keeps away from where all is small. Distances are those of a chamfer mask (5, 7).
void limit_growth(cv::Mat& sizes, float slope);

}  // namespace tessera
