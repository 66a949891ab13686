#include "products/elements/ground_pixels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "products/elements/gap_appearance.h"
#include "products/elements/segmentation/region_labels.h"

namespace tessera {
namespace {

/// Side of the cells of gap that are judged as a whole, px of the working copy.
constexpr int kCell_px = 3;
/// Width of the soft edge of an element, px of the photo.
constexpr int kSoftEdge_px = 2;
/// Samples with fewer pixels teach nothing.
constexpr int kLeastSample_px2 = 100;

/// Upper bound of the working copy: its features take some 70 bytes a pixel.
constexpr double kMostGround_px2 = 2e6;

/// Scale of the working copy, relative to the photo. An element of the median size becomes kElement_px large, as the
/// features need it, or smaller where there are very many.
double working_zoom(const LabelRuns& labels) {
  const double possible = std::min(1., std::sqrt(kMostGround_px2 / std::max(1., double(labels.size().area()))));
  std::vector<double> areas;
  for (const RegionBox& region : labels.regions()) {
    if (region.area_px2 > 0) areas.push_back(region.area_px2);
  }
  if (areas.empty()) return possible;
  const auto middle = areas.begin() + std::ptrdiff_t(areas.size() / 2);
  std::nth_element(areas.begin(), middle, areas.end());
  return std::min(possible, kElement_px / std::sqrt(*middle));
}

cv::Mat resized(const cv::Mat& picture, cv::Size size, int filter) {
  cv::Mat result;
  cv::resize(picture, result, size, 0, 0, filter);
  return result;
}

/// Numbers the cells of the mask, from 1: each pixel has its cell's number, CV_32S.
cv::Mat cells_of(const cv::Mat& mask) {
  const int columns = (mask.cols + kCell_px - 1) / kCell_px;
  cv::Mat cells = cv::Mat::zeros(mask.size(), CV_32S);
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      if (mask.at<std::uint8_t>(y, x)) cells.at<int>(y, x) = y / kCell_px * columns + x / kCell_px + 1;
    }
  }
  return cells;
}

/// The part of the gap that looks like most of the gap rather than like elements. It judges twice, because elements that
/// were not found spoil the first model of the gap.
cv::Mat like_gap(const cv::Mat& bgr, const cv::Mat& gap, const cv::Mat& element) {
  const cv::Mat features = appearance_features(bgr), cells = cells_of(gap);
  cv::Mat like = gap.clone();
  for (int round = 0; round < 2 && cv::countNonZero(like) >= kLeastSample_px2; ++round) {
    const std::vector<char> is_like_gap = are_like_gap(cells, features, like, element);
    for (int y = 0; y < gap.rows; ++y) {
      for (int x = 0; x < gap.cols; ++x) {
        like.at<std::uint8_t>(y, x) = is_like_gap[std::size_t(cells.at<int>(y, x))] ? 255 : 0;
      }
    }
  }
  return like;
}

/// The part of the photo that is ground. It includes cells that were not judged because elements cover part of them, and
/// single cells that look different.
double part_of_photo(const cv::Mat& like_gap, const cv::Mat& is_gap) {
  cv::Mat whole;
  cv::morphologyEx(like_gap, whole, cv::MORPH_CLOSE, round_window(2 * kCell_px + 1));
  cv::dilate(whole, whole, round_window(3));
  whole = resized(whole, is_gap.size(), cv::INTER_NEAREST);
  cv::bitwise_and(whole, is_gap, whole);
  return double(cv::countNonZero(whole)) / double(is_gap.total());
}

}  // namespace

GroundPixels ground_pixels(const cv::Mat& photo, const LabelRuns& labels) {
  const double zoom = working_zoom(labels);
  const cv::Size size(std::max(1, int(photo.cols * zoom)), std::max(1, int(photo.rows * zoom)));
  cv::Mat is_gap = labels.mask();
  cv::bitwise_not(is_gap, is_gap);
  const cv::Mat gap = resized(is_gap, size, cv::INTER_AREA) > 250, element = resized(is_gap, size, cv::INTER_AREA) < 5;
  if (std::min(cv::countNonZero(gap), cv::countNonZero(element)) < kLeastSample_px2) {
    return {cv::Mat::zeros(labels.size(), CV_8U), 0};
  }
  const cv::Mat like_there = like_gap(bgr_of(resized(photo, size, cv::INTER_AREA)), gap, element);
  const double part = part_of_photo(like_there, is_gap);
  cv::erode(is_gap, is_gap, round_window(2 * kSoftEdge_px + 1));
  cv::bitwise_and(is_gap, resized(like_there, labels.size(), cv::INTER_NEAREST), is_gap);
  return {is_gap, part};
}

}  // namespace tessera
