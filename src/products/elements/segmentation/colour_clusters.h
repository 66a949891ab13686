// k-means that always gives the same clusters, whatever other code has drawn random numbers.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

/// The number (0 to count - 1) of each pixel's cluster, CV_8U. `colours`: CV_32FC3, not empty. `count` <= 255.
cv::Mat colour_clusters(const cv::Mat& colours, int count);

}  // namespace tessera
