// Converts between straight and premultiplied alpha, CV_8UC4 BGRA. Scaling and averaging need premultiplied pixels,
// files straight ones.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

cv::Mat premultiplied(const cv::Mat& straight);
// The next two functions work in place: a picture may be too large to be in memory twice.
void premultiply(cv::Mat& straight);
void straighten(cv::Mat& premultiplied);
cv::Mat straightened(const cv::Mat& premultiplied);

}  // namespace tessera
