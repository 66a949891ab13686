#include "products/elements/trim.h"

#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "products/elements/segmentation/region_labels.h"

namespace tessera {
namespace {

constexpr double kSmallest_px2 = 60;
/// Smaller differences of colours (CIELAB, a and b times 1.5) do not count.
constexpr double kMarginContrast = 4;
/// Part of a region that must remain, if it is cut at all.
constexpr double kLeastLeft = 0.5;
/// Place of the cut between the core's colour (0) and the rim's (1).
constexpr double kCutAt = 0.6;

cv::Vec3f weighted(const cv::Vec3f& lab) { return {lab[0], 1.5F * lab[1], 1.5F * lab[2]}; }

cv::Vec3f median_of(const std::vector<cv::Vec3f>& colours) {
  cv::Vec3f median;
  std::vector<float> values(colours.size());  // of one channel: sorting them takes half the time of sorting colours
  for (int c = 0; c < 3; ++c) {
    std::transform(colours.begin(), colours.end(), values.begin(), [c](const cv::Vec3f& colour) { return colour[c]; });
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    median[c] = *middle;
  }
  return median;
}

/// The part of `mask` to keep; empty: all of it.
cv::Mat without_rim(const cv::Mat& mask, const cv::Mat& lab) {
  cv::Mat framed, distance;
  cv::copyMakeBorder(mask, framed, 1, 1, 1, 1, cv::BORDER_CONSTANT, 0);
  cv::distanceTransform(framed, distance, cv::DIST_L2, 3);
  distance = distance(cv::Rect({1, 1}, mask.size()));
  double thickest = 0;
  cv::minMaxLoc(distance, nullptr, &thickest);
  std::vector<cv::Vec3f> core;
  cv::Vec3d rim_sum{0, 0, 0};
  int rim_count = 0;
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      if (!mask.at<std::uint8_t>(y, x)) continue;
      const cv::Vec3f colour = weighted(lab.at<cv::Vec3f>(y, x));
      if (distance.at<float>(y, x) > 0.35 * thickest) core.push_back(colour);
      if (distance.at<float>(y, x) > 2) continue;
      rim_sum += cv::Vec3d(colour);
      ++rim_count;
    }
  }
  if (core.empty() || rim_count == 0) return {};
  const cv::Vec3f core_colour = median_of(core);
  const cv::Vec3f way = cv::Vec3f(rim_sum / rim_count) - core_colour;
  const float length2 = way.dot(way);
  if (length2 < kMarginContrast * kMarginContrast) return {};
  cv::Mat place(mask.size(), CV_32F);
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      place.at<float>(y, x) = (weighted(lab.at<cv::Vec3f>(y, x)) - core_colour).dot(way) / length2;
    }
  }
  cv::GaussianBlur(place, place, {}, 0.8);
  cv::Mat kept = mask & (place < kCutAt);
  cv::morphologyEx(kept, kept, cv::MORPH_OPEN, round_window(3));
  return solid_part(kept) & mask;
}

}  // namespace

cv::Mat trimmed_regions(const cv::Mat& labels, const cv::Mat& lab) {
  cv::Mat trimmed = labels.clone();
  const std::vector<RegionBox> regions = region_boxes(labels);
  for (std::size_t i = 1; i < regions.size(); ++i) {
    if (regions[i].area_px2 < kSmallest_px2) continue;
    const cv::Mat mask = labels(regions[i].box) == int(i);
    const cv::Mat kept = without_rim(mask, lab(regions[i].box));
    if (kept.empty() || cv::countNonZero(kept) < kLeastLeft * regions[i].area_px2) continue;
    trimmed(regions[i].box).setTo(0, mask & ~kept);
  }
  return trimmed;
}

}  // namespace tessera
