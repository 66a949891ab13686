#include "job/canvas/whole_regions.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <opencv2/imgproc.hpp>

#include "artwork/nearest_pixels.h"
#include "job/canvas/canvas_regions.h"

namespace tessera {
namespace {

/// Reach from a pixel on a border to certain pixels on both sides: a drawn border is two px wide, and its neighbours
/// are not certain either.
constexpr int kBorderReach_px = 3;

/// CV_8U: 255 where a pixel and all its neighbours have the same label and are at least half opaque.
cv::Mat_<std::uint8_t> certain_places(const cv::Mat_<short>& labels, const cv::Mat& page_bgra) {
  cv::Mat alpha;
  cv::extractChannel(page_bgra, alpha, 3);
  cv::Mat_<short> opaque = labels.clone();
  opaque.setTo(kNoRegion, alpha < 128);
  cv::Mat lowest, highest;
  const cv::Mat around = cv::Mat::ones(3, 3, CV_8U);
  cv::erode(opaque, lowest, around);
  cv::dilate(opaque, highest, around);
  return cv::Mat((lowest == highest) & (opaque != kNoRegion));
}

/// The label of the nearest certain pixel, for each pixel.
cv::Mat_<short> nearest_labels(const cv::Mat_<short>& labels, const cv::Mat_<std::uint8_t>& certain) {
  const NearestPixels certain_pixels(certain);
  cv::Mat_<short> whole(labels.size(), short(kNoRegion));
  for (int y = 0; y < labels.rows; ++y) {
    for (int x = 0; x < labels.cols; ++x) {
      if (const auto nearest = certain_pixels.nearest({x, y})) whole(y, x) = labels(*nearest);
    }
  }
  return whole;
}

cv::Vec3d colour_at(const cv::Mat& page_bgra, int x, int y) {
  const cv::Vec4b& pixel = page_bgra.at<cv::Vec4b>(y, x);
  return {double(pixel[0]), double(pixel[1]), double(pixel[2])};
}

/// The mean colour of each region that has certain pixels near the place, by region number.
std::map<short, cv::Vec3d> colours_near(cv::Point at, const cv::Mat_<short>& labels,
                                        const cv::Mat_<std::uint8_t>& certain, const cv::Mat& page_bgra) {
  std::map<short, cv::Vec3d> sums;
  std::map<short, int> counts;
  for (int y = std::max(0, at.y - kBorderReach_px); y <= std::min(labels.rows - 1, at.y + kBorderReach_px); ++y) {
    for (int x = std::max(0, at.x - kBorderReach_px); x <= std::min(labels.cols - 1, at.x + kBorderReach_px); ++x) {
      if (!certain(y, x)) continue;
      sums[labels(y, x)] += colour_at(page_bgra, x, y);
      ++counts[labels(y, x)];
    }
  }
  for (auto& [label, sum] : sums) sum /= counts[label];
  return sums;
}

std::vector<BorderPlace> border_places(const cv::Mat_<short>& labels, const cv::Mat_<std::uint8_t>& certain,
                                       const cv::Mat& page_bgra) {
  std::vector<BorderPlace> places;
  for (int y = 0; y < labels.rows; ++y) {
    for (int x = 0; x < labels.cols; ++x) {
      if (certain(y, x) || page_bgra.at<cv::Vec4b>(y, x)[3] < 128) continue;
      const std::map<short, cv::Vec3d> near = colours_near({x, y}, labels, certain, page_bgra);
      if (near.size() != 2) continue;
      const auto& [first, from] = *near.begin();
      const auto& [second, to] = *near.rbegin();
      const cv::Vec3d way = to - from;
      const double share = (colour_at(page_bgra, x, y) - from).dot(way) / std::max(1., way.dot(way));
      places.push_back({{x, y}, first, second, float(std::clamp(share, 0., 1.))});
    }
  }
  return places;
}

}  // namespace

WholeRegions whole_regions(const cv::Mat_<short>& labels, const cv::Mat& page_bgra) {
  const cv::Mat_<std::uint8_t> certain = certain_places(labels, page_bgra);
  return {nearest_labels(labels, certain), border_places(labels, certain, page_bgra)};
}

}  // namespace tessera
