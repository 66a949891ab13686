// Random maps of labels, for properties.
#pragma once

#include <rapidcheck.h>

#include <opencv2/core.hpp>

namespace tessera::test {

/// Rectangles at random places, of which later ones cover earlier ones. A rectangle that is cut into parts is one element.
inline cv::Mat random_labels(cv::Size size) {
  cv::Mat labels = cv::Mat::zeros(size, CV_32S);
  const int count = *rc::gen::inRange(2, 14);
  for (int label = 1; label <= count; ++label) {
    const cv::Size sides(*rc::gen::inRange(4, 20), *rc::gen::inRange(4, 20));
    const cv::Point corner(*rc::gen::inRange(-4, size.width - 4), *rc::gen::inRange(-4, size.height - 4));
    labels(cv::Rect(corner, sides) & cv::Rect({}, labels.size())) = label;
  }
  return labels;
}

}  // namespace tessera::test
