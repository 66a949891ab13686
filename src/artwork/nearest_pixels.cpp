#include "artwork/nearest_pixels.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <opencv2/imgproc.hpp>

namespace tessera {

NearestPixels::NearestPixels(const cv::Mat& mask) {
  const int count = cv::countNonZero(mask);
  if (count == 0) return;
  cv::distanceTransform(~mask, distances_px_, labels_, cv::DIST_L2, cv::DIST_MASK_5, cv::DIST_LABEL_PIXEL);
  places_.resize(std::size_t(count) + 1);
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      if (mask.at<std::uint8_t>(y, x)) places_[std::size_t(labels_.at<int>(y, x))] = {x, y};
    }
  }
}

float NearestPixels::distance_px(cv::Point at) const {
  return places_.empty() ? std::numeric_limits<float>::infinity() : distances_px_.at<float>(at);
}

std::optional<cv::Point> NearestPixels::nearest(cv::Point at) const {
  if (places_.empty()) return {};
  return places_[std::size_t(labels_.at<int>(at))];
}

}  // namespace tessera
