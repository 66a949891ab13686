// Finds the nearest pixel of a mask.
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

namespace tessera {

class NearestPixels {
 public:
  /// `mask`: CV_8U, 255 at its pixels, else 0.
  explicit NearestPixels(const cv::Mat& mask);

  /// The distance to the nearest pixel of the mask; infinite where the mask is empty.
  float distance_px(cv::Point at) const;
  /// The nearest pixel of the mask to this one, itself where it is one; nullopt where the mask is empty.
  std::optional<cv::Point> nearest(cv::Point at) const;

 private:
  cv::Mat distances_px_;           // CV_32F; empty: the mask is empty
  cv::Mat labels_;                 // CV_32S
  std::vector<cv::Point> places_;  // of labels
};

}  // namespace tessera
