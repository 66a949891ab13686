// Estimates the colour of a plain ground over a photo: one colour in a light that changes slowly.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

/// Each channel is a polynomial of the second degree in x and y.
class GroundLight {
 public:
  /// Fits it by least squares to the pixels that `is_ground` marks (CV_8U, of the picture's size). `lab`: CV_32FC3, CIELAB.
  GroundLight(const cv::Mat& lab, const cv::Mat& is_ground);

  /// The ground's colour, CIELAB, CV_32FC3, for a copy of the picture in that size.
  cv::Mat over(cv::Size size) const;

 private:
  static constexpr int kTerms = 6;
  static cv::Vec<double, kTerms> terms(int x, int y, cv::Size size);

  cv::Matx<double, kTerms, 3> weights_;
};

}  // namespace tessera
