// From a photograph and a map of labels to the elements in it (stones, tiles, coins), each with its own pixels.
#pragma once

#include <cstddef>
#include <limits>
#include <opencv2/core.hpp>
#include <vector>

#include "products/elements/segmentation/label_runs.h"

namespace tessera {

/// Of an element's size: the square root of its area, px of the photo.
struct ElementSizes {
  double least_px = 0;
  double most_px = std::numeric_limits<double>::infinity();
};

struct PhotoElement {
  int label = 0;
  cv::Rect box;  // of its pixels, in the photo
  double area_px2 = 0;
};

struct FoundElements {
  std::vector<PhotoElement> elements;  // by the upper, then the left edge of their boxes
  std::size_t at_edge = 0;             // left out: they reach the photo's edge, which cuts them
  std::size_t too_small = 0;
  std::size_t too_large = 0;
  std::size_t too_many_pixels = 0;  // their box has more than kMostElement_px2
};

/// Of an element's box: larger ones are not cut out.
inline constexpr int kMostElement_px2 = 16'000'000;

FoundElements find_elements(const LabelRuns& labels, const ElementSizes& sizes);

/// The element cut out, with a transparent rim: straight BGRA, CV_8UC4. Half of the opacity lies on the edge of its
/// pixels, holes are filled, and beyond the edge the element's own colours go on, so that no gap shines through.
/// `photo`: CV_8UC4 of the size of the labels.
cv::Mat cut_element(const cv::Mat& photo, const LabelRuns& labels, const PhotoElement& element);

}  // namespace tessera
