#include "products/elements/segmentation/distance_split.h"

#include <opencv2/imgproc.hpp>

#include "products/elements/segmentation/region_labels.h"
#include "products/elements/segmentation/relief_watershed.h"

namespace tessera {
namespace {

/// A neck wider than this part of the smaller side's thickness belongs to one element.
constexpr float kNeck = 0.75F;
/// Regions that are nowhere thicker (from the middle line to the gap) are no elements.
constexpr float kLeastRadius_px = kElement_px * 0.1F;

}  // namespace

cv::Mat split_by_distance(const cv::Mat& mask) {
  cv::Mat distance;
  cv::distanceTransform(mask, distance, cv::DIST_L2, 5);
  cv::GaussianBlur(distance, distance, {}, 1.5);
  const cv::Mat relief = -distance;
  const cv::Mat parts = BasinMerger(relief, basins_of(relief, mask)).merged([](float saddle, float floor) {
    return -saddle > kNeck * -floor;
  });
  double count = 0;
  cv::minMaxLoc(parts, nullptr, &count);
  std::vector<char> is_thick(std::size_t(count) + 1, 0);
  for (int y = 0; y < parts.rows; ++y) {
    for (int x = 0; x < parts.cols; ++x) {
      if (distance.at<float>(y, x) > kLeastRadius_px) is_thick[std::size_t(parts.at<int>(y, x))] = 1;
    }
  }
  cv::Mat thick = parts.clone();
  for (int y = 0; y < parts.rows; ++y) {
    for (int x = 0; x < parts.cols; ++x) {
      if (!is_thick[std::size_t(parts.at<int>(y, x))]) thick.at<int>(y, x) = 0;
    }
  }
  return thick;
}

}  // namespace tessera
