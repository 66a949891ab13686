#include "io/elements/connected_labels.h"

#include <array>
#include <vector>

namespace tessera::io {
namespace {

constexpr int kUnseen = 0, kGap = -1;

/// The pixels that hang together with `seed` and have its value; they get `label`.
void fill(const cv::Mat& values, cv::Mat& labels, cv::Point seed, int label, std::vector<cv::Point>& region) {
  const int value = values.at<int>(seed);
  const cv::Rect all({}, values.size());
  labels.at<int>(seed) = label;
  region.assign(1, seed);
  for (std::size_t i = 0; i < region.size(); ++i) {
    for (const cv::Point& step : std::array{cv::Point(1, 0), cv::Point(-1, 0), cv::Point(0, 1), cv::Point(0, -1)}) {
      const cv::Point next = region[i] + step;
      if (!all.contains(next) || labels.at<int>(next) != kUnseen || values.at<int>(next) != value) continue;
      labels.at<int>(next) = label;
      region.push_back(next);
    }
  }
}

}  // namespace

cv::Mat connected_labels(const cv::Mat& labels) {
  if (labels.empty()) return {};
  cv::Mat result = cv::Mat::zeros(labels.size(), CV_32S);
  std::vector<cv::Point> region;
  int count = 0;
  for (int y = 0; y < labels.rows; ++y) {
    for (int x = 0; x < labels.cols; ++x) {
      if (labels.at<int>(y, x) <= 0 || result.at<int>(y, x) != kUnseen) continue;
      fill(labels, result, {x, y}, count + 1, region);
      if (region.size() >= std::size_t(kLeastRegion_px2)) {
        ++count;
      } else {
        for (const cv::Point& pixel : region) result.at<int>(pixel) = kGap;
      }
    }
  }
  return cv::max(result, 0);
}

}  // namespace tessera::io
