// Drawn photos of elements whose true labels are known.
#pragma once

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "products/elements/segmentation/region_labels.h"

namespace tessera::test {

/// A photo and its truth: CV_32S, 0 = gap, 1..n = elements.
struct ElementPhoto {
  cv::Mat bgr, truth;
};

/// Draws each element in its own colour near `element`, with light from one side, texture and noise.
inline ElementPhoto photographed(const cv::Mat& truth, const cv::Scalar& element, const cv::Scalar& gap) {
  cv::RNG random(11);
  cv::Mat photo(truth.size(), CV_32FC3, gap);
  for (std::size_t i = 1; i < region_boxes(truth).size(); ++i) {
    photo.setTo(element + cv::Scalar::all(random.uniform(-15., 15.)), truth == int(i));
  }
  cv::Mat texture(truth.size(), CV_32F), noise(truth.size(), CV_32FC3);
  random.fill(texture, cv::RNG::NORMAL, 0, 20);
  cv::GaussianBlur(texture, texture, {}, 1.5);
  for (int y = 0; y < texture.rows; ++y) {
    for (int x = 0; x < texture.cols; ++x) {
      const float light = texture.at<float>(y, x) + 20.F * float(x) / float(texture.cols) - 10;
      photo.at<cv::Vec3f>(y, x) += cv::Vec3f::all(light);
    }
  }
  cv::GaussianBlur(photo, photo, {}, 1);
  random.fill(noise, cv::RNG::NORMAL, 0, 3);
  ElementPhoto result;
  cv::Mat(photo + noise).convertTo(result.bgr, CV_8U);
  result.truth = truth;
  return result;
}

/// Discs of 20 to 28 px radius in a grid; some touch their neighbour.
inline cv::Mat discs() {
  cv::Mat truth = cv::Mat::zeros(320, 420, CV_32S);
  for (int i = 0; i < 20; ++i) {
    const int radius_px = 20 + i % 5 * 2;
    const int shift_px = i % 5 == 3 ? 8 : 0;  // nearer to the next disc, which is large
    cv::circle(truth, {50 + i % 5 * 74 + shift_px, 45 + i / 5 * 76}, radius_px, i + 1, cv::FILLED);
  }
  return truth;
}

/// Four rows of bricks with joints of 8 px. Every second row is shifted; the edge cuts some bricks.
inline cv::Mat bricks() {
  cv::Mat truth = cv::Mat::zeros(260, 420, CV_32S);
  int count = 0;
  for (int row = 0; row < 5; ++row) {
    for (int i = -1; i < 5; ++i) {
      const cv::Rect brick(i * 108 + row % 2 * 54, row * 52 + 4, 100, 44);
      const cv::Rect seen = brick & cv::Rect({0, 0}, truth.size());
      if (!seen.empty()) truth(seen) = ++count;
    }
  }
  return truth;
}

/// The cells of randomly moved grid points, 8 px apart.
inline cv::Mat cobbles() {
  cv::RNG random(5);
  cv::Mat truth = cv::Mat::zeros(330, 420, CV_32S);
  std::vector<cv::Point2d> centres;
  for (int i = 0; i < 42; ++i) {
    centres.emplace_back((i % 7 + 0.5 + i / 7 % 2 * 0.4 + random.uniform(-.2, .2)) * 60,
                         (i / 7 + 0.5 + random.uniform(-.2, .2)) * 55);
  }
  for (int y = 0; y < truth.rows; ++y) {
    for (int x = 0; x < truth.cols; ++x) {
      std::vector<std::pair<double, int>> near;
      for (int i = 0; i < 42; ++i) near.emplace_back(cv::norm(centres[std::size_t(i)] - cv::Point2d(x, y)), i);
      std::partial_sort(near.begin(), near.begin() + 2, near.end());
      if (near[1].first - near[0].first > 8) truth.at<int>(y, x) = near[0].second + 1;
    }
  }
  return truth;
}

}  // namespace tessera::test
