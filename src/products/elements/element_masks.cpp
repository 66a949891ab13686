#include "products/elements/element_masks.h"

#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>

#include "products/elements/segmentation/colour_clusters.h"
#include "products/elements/segmentation/mask_parts.h"
#include "products/elements/segmentation/region_labels.h"

namespace tessera {
namespace {

/// The Gaussian for the local brightness; the factor is in sides of an element.
constexpr double kNeighbourhood_px = kElement_px * 0.625;
constexpr std::array kLevels = {-0.6, -0.3, 0.};

/// The grey, relative to its local mean, in local standard deviations.
cv::Mat normalised_grey(const cv::Mat& bgr) {
  cv::Mat grey, mean, variance;
  cv::cvtColor(bgr, grey, cv::COLOR_BGR2GRAY);
  grey.convertTo(grey, CV_32F);
  cv::GaussianBlur(grey, grey, {}, 1.2);
  cv::GaussianBlur(grey, mean, {}, kNeighbourhood_px);
  grey -= mean;
  cv::GaussianBlur(grey.mul(grey), variance, {}, kNeighbourhood_px);
  cv::sqrt(variance, variance);
  return grey / (variance + 2);
}

/// The area of regions of a usual size that fill their bounding box.
double compact_area_px2(const cv::Mat& mask) {
  double sum = 0;
  for (const RegionBox& region : mask_parts(mask)) {
    const bool is_usual = region.area_px2 > 0.15 * kElement_px2 && region.area_px2 < 6 * kElement_px2;
    if (is_usual && region.area_px2 > 0.6 * region.box.width * double(region.box.height)) sum += region.area_px2;
  }
  return sum;
}

}  // namespace

LevelMasks level_masks(const cv::Mat& bgr) {
  const cv::Mat grey = normalised_grey(bgr);
  LevelMasks masks;
  for (const double level : kLevels) {
    cv::Mat bright, dark;
    cv::morphologyEx(grey > level, bright, cv::MORPH_OPEN, round_window(5));
    cv::morphologyEx(grey < -level, dark, cv::MORPH_OPEN, round_window(5));
    masks.bright.push_back(bright);
    masks.dark.push_back(dark);
  }
  return masks;
}

cv::Mat relative_colours(const cv::Mat& lab) {
  cv::Mat lightness, surroundings;
  cv::extractChannel(lab, lightness, 0);
  cv::GaussianBlur(lightness, surroundings, {}, kElement_px);
  lightness -= 0.7 * surroundings;
  cv::Mat colours = lab.clone();
  cv::insertChannel(lightness, colours, 0);
  cv::multiply(colours, cv::Scalar(0.7, 1.5, 1.5), colours);
  return colours;
}

cv::Mat colour_mask(const cv::Mat& colours, int colour_count) {
  const cv::Mat cluster = colour_clusters(colours, colour_count);
  cv::Mat best;
  double most_px2 = -1;
  for (int chosen = 1; chosen + 1 < 1 << colour_count; ++chosen) {
    cv::Mat table(1, 256, CV_8U, cv::Scalar(0));
    for (int i = 0; i < colour_count; ++i) table.at<std::uint8_t>(i) = chosen >> i & 1 ? 255 : 0;
    cv::Mat mask;
    cv::LUT(cluster, table, mask);
    cv::morphologyEx(mask, mask, cv::MORPH_OPEN, round_window(5));
    cv::morphologyEx(mask, mask, cv::MORPH_CLOSE, round_window(3));
    const double area_px2 = compact_area_px2(mask);
    if (area_px2 <= most_px2) continue;
    most_px2 = area_px2;
    best = mask;
  }
  return best;
}

}  // namespace tessera
