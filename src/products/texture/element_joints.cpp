#include "products/texture/element_joints.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "artwork/nearest_pixels.h"

namespace tessera {
namespace {

/// Finds the nearest pixel of an element for each pixel.
cv::Mat nearest_pixels(const cv::Mat& labels) {
  const NearestPixels elements(labels > 0);
  cv::Mat nearest(labels.size(), CV_32SC2);
  for (int y = 0; y < labels.rows; ++y) {
    for (int x = 0; x < labels.cols; ++x) nearest.at<cv::Point>(y, x) = *elements.nearest({x, y});
  }
  return nearest;
}

}  // namespace

std::vector<JointPlace> joint_places(const cv::Mat& labels, float most_px) {
  if (cv::countNonZero(labels) == 0) return {};
  const cv::Mat nearest = nearest_pixels(labels);
  std::vector<JointPlace> places;
  const auto add = [&](cv::Point from, cv::Point to) {
    cv::Point a = nearest.at<cv::Point>(from), b = nearest.at<cv::Point>(to);
    if (labels.at<int>(a) == labels.at<int>(b)) return;
    if (labels.at<int>(a) > labels.at<int>(b)) std::swap(a, b);
    const cv::Vec2f across(float(b.x - a.x), float(b.y - a.y));
    const float distance_px = std::hypot(across[0], across[1]);  // 1 where they touch
    if (distance_px - 1 > most_px) return;
    places.push_back({labels.at<int>(a), labels.at<int>(b), across / distance_px, distance_px - 1});
  };
  for (int y = 0; y < labels.rows; ++y) {
    for (int x = 0; x < labels.cols; ++x) {
      if (x + 1 < labels.cols) add({x, y}, {x + 1, y});
      if (y + 1 < labels.rows) add({x, y}, {x, y + 1});
    }
  }
  std::stable_sort(places.begin(), places.end(), [](const JointPlace& a, const JointPlace& b) {
    return std::tie(a.first, a.second) < std::tie(b.first, b.second);
  });
  return places;
}

}  // namespace tessera
