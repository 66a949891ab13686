// k-means that gives the same clusters each time, whatever else has drawn random numbers.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

/// `colours`: CV_32FC3, not empty. CV_8U of its size: the number 0..count-1 of each pixel's cluster. `count` <= 255.
cv::Mat colour_clusters(const cv::Mat& colours, int count);

}  // namespace tessera
