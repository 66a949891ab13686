#include "products/elements/plain_ground.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "products/elements/ground_light.h"
#include "products/elements/segmentation/connected_labels.h"
#include "products/elements/segmentation/region_labels.h"

namespace tessera {
namespace {

/// Pixels of the copy in which elements are found, and of the copy from which the ground's colour is estimated.
constexpr double kMostLookedAt_px2 = 6e6, kMostFitted_px2 = 1e5;
/// The Gaussian that removes the noise of single pixels and of JPEG blocks.
constexpr double kSmooth_px = 1;
/// Largest difference (CIELAB) of a pixel at the photo's edge from the edge's median, for it to count as ground before the
/// light is known.
constexpr float kFirstReach = 25;
constexpr int kFits = 8;
/// Ground differs from its light (CIELAB) by a median, its deviation. A pixel is ground up to kReach deviations, or
/// kLeastReach if that is more. A ground with a deviation above kMostDeviation is not plain.
constexpr float kReach = 4, kLeastReach = 5, kMostDeviation = 3.5F;
/// The edge is a band of width kEdge, as a part of the photo's shorter side. Plain ground must be seen in kLeastAtEdge of
/// it.
constexpr double kEdge = 0.03, kLeastAtEdge = 0.75;
/// The part of the ground that must be connected. Joints between stones are not.
constexpr double kLeastTogether = 0.9;
/// Elements must differ from the ground by so many times its reach. Otherwise they are the ground's own roughness.
constexpr double kLeastStandingOut = 2;
/// A pixel is a shadow if its colour is the ground's colour made darker (except for kSameHue, colours from 0 to 1) and
/// differs from the ground by less than kMostShadow of the elements' difference.
constexpr double kMostShadow = 0.4, kSameHue = 0.04;
/// An element ends where the difference is half of the difference so many px further inside.
constexpr int kEdgeReach_px = 2;
/// A photo with a shorter side holds no elements.
constexpr int kLeastPhoto_px = 16;

/// The distance of the colours of two pictures at each pixel: CV_32F.
cv::Mat difference_of(const cv::Mat& a, const cv::Mat& b) {
  cv::Mat all(a.size(), CV_32F);
  for (int y = 0; y < a.rows; ++y) {
    for (int x = 0; x < a.cols; ++x)
      all.at<float>(y, x) = float(cv::norm(a.at<cv::Vec3f>(y, x) - b.at<cv::Vec3f>(y, x)));
  }
  return all;
}

/// Marks pixels whose colour is the ground's colour made darker: CV_8U.
cv::Mat shadow_like(const cv::Mat& bgr, const cv::Mat& ground_bgr) {
  cv::Mat all(bgr.size(), CV_8U);
  for (int y = 0; y < bgr.rows; ++y) {
    for (int x = 0; x < bgr.cols; ++x) {
      const cv::Vec3f here = bgr.at<cv::Vec3f>(y, x), ground = ground_bgr.at<cv::Vec3f>(y, x);
      const double times = here.dot(ground) / std::max(1e-6F, ground.dot(ground));
      all.at<std::uint8_t>(y, x) = times < 1 && cv::norm(here - ground * times) < kSameHue ? 255 : 0;
    }
  }
  return all;
}

cv::Mat copy_of(const cv::Mat& photo, double most_px2) {
  const double zoom = std::min(1., std::sqrt(most_px2 / (double(photo.cols) * photo.rows)));
  cv::Mat copy = bgr_of(photo);
  const cv::Size size(std::max(1, int(photo.cols * zoom)), std::max(1, int(photo.rows * zoom)));
  if (size != photo.size()) cv::resize(copy, copy, size, 0, 0, cv::INTER_AREA);
  return copy;
}

/// The smoothed picture, CV_32FC3, 0 to 1.
cv::Mat smooth_of(const cv::Mat& bgr) {
  cv::Mat smooth;
  bgr.convertTo(smooth, CV_32FC3, 1. / 255);
  cv::GaussianBlur(smooth, smooth, {}, kSmooth_px);
  return smooth;
}

cv::Mat edge_mask(cv::Size size) {
  cv::Mat edge(size, CV_8U, cv::Scalar(255));
  const int width = std::max(2, int(kEdge * std::min(size.width, size.height)));
  if (2 * width < std::min(size.width, size.height))
    edge(cv::Rect(width, width, size.width - 2 * width, size.height - 2 * width)).setTo(0);
  return edge;
}

float median_of(const cv::Mat& values, const cv::Mat& mask) {
  std::vector<float> all;
  for (int y = 0; y < values.rows; ++y) {
    for (int x = 0; x < values.cols; ++x) {
      if (mask.at<std::uint8_t>(y, x)) all.push_back(values.at<float>(y, x));
    }
  }
  if (all.empty()) return 0;
  const auto middle = all.begin() + std::ptrdiff_t(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end());
  return *middle;
}

cv::Mat difference_from_median(const cv::Mat& lab, const cv::Mat& mask) {
  std::vector<cv::Mat> channels;
  cv::split(lab, channels);
  cv::Mat sum = cv::Mat::zeros(lab.size(), CV_32F);
  for (const cv::Mat& channel : channels) {
    const cv::Mat away = channel - double(median_of(channel, mask));
    sum += away.mul(away);
  }
  cv::sqrt(sum, sum);
  return sum;
}

double part_of(const cv::Mat& mask, const cv::Mat& of) {
  return double(cv::countNonZero(mask & of)) / std::max(1, cv::countNonZero(of));
}

bool hangs_together(const cv::Mat& ground) {
  cv::Mat labels, stats, centroids;
  const int count = cv::connectedComponentsWithStats(ground, labels, stats, centroids, 4);
  int largest = 0;
  for (int i = 1; i < count; ++i) largest = std::max(largest, stats.at<int>(i, cv::CC_STAT_AREA));
  return largest >= kLeastTogether * cv::countNonZero(ground);
}

struct Ground {
  GroundLight light;
  float reach = 0;  // CIELAB
};

std::optional<Ground> plain_ground(const cv::Mat& photo) {
  cv::Mat lab;
  cv::cvtColor(smooth_of(copy_of(photo, kMostFitted_px2)), lab, cv::COLOR_BGR2Lab);
  const cv::Mat edge = edge_mask(lab.size());
  cv::Mat is_ground = edge & (difference_from_median(lab, edge) < kFirstReach);
  float reach = kFirstReach, deviation = 0;
  std::optional<GroundLight> light;
  for (int fit = 0; fit < kFits; ++fit) {
    if (cv::countNonZero(is_ground) == 0) return {};
    light.emplace(lab, is_ground);
    const cv::Mat away = difference_of(lab, light->over(lab.size()));
    // The first fits use only the edge, where ground is most likely; the last ones all pixels that are like it.
    const cv::Mat all = fit < kFits / 2 ? edge : cv::Mat(lab.size(), CV_8U, cv::Scalar(255));
    deviation = median_of(away, all & (away < reach));
    reach = std::max(kLeastReach, kReach * deviation);
    is_ground = all & (away < reach);
  }
  if (deviation > kMostDeviation || part_of(is_ground, edge) < kLeastAtEdge || !hangs_together(is_ground)) return {};
  return Ground{*light, reach};
}

/// Marks pixels of elements, which differ enough from the ground and are no shadow: CV_8U. Empty where elements differ too
/// little.
std::optional<cv::Mat> standing_out(const cv::Mat& bgr, const Ground& ground) {
  cv::Mat lab, inside;
  cv::cvtColor(bgr, lab, cv::COLOR_BGR2Lab);
  cv::Mat colour = ground.light.over(lab.size());
  const cv::Mat difference = difference_of(lab, colour);
  cv::cvtColor(colour, colour, cv::COLOR_Lab2BGR);
  cv::dilate(difference, inside, round_window(2 * kEdgeReach_px + 1));
  cv::Mat mask = (difference > double(ground.reach)) & (difference > 0.5 * inside);
  const double contrast = double(median_of(difference, mask));
  if (contrast < kLeastStandingOut * double(ground.reach)) return {};
  mask.setTo(0, shadow_like(bgr, colour) & (difference < kMostShadow * contrast));
  return mask;
}

}  // namespace

std::optional<cv::Mat> elements_on_plain_ground(const cv::Mat& photo) {
  if (std::min(photo.cols, photo.rows) < kLeastPhoto_px) return {};
  const std::optional<Ground> ground = plain_ground(photo);
  if (!ground) return {};
  const std::optional<cv::Mat> mask = standing_out(smooth_of(copy_of(photo, kMostLookedAt_px2)), *ground);
  if (!mask) return {};
  cv::Mat labels;
  cv::connectedComponents(*mask, labels, 4);
  return solid_regions(labels, kLeastRegion_px2, 0);
}

}  // namespace tessera
