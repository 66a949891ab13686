// Lists the elements (stones, tiles, coins) of a map of labels, and cuts them out of the photograph with their own pixels.
#pragma once

#include <cstddef>
#include <limits>
#include <opencv2/core.hpp>
#include <vector>

#include "products/elements/segmentation/label_runs.h"

namespace tessera {

/// Limits of an element's size: the square root of its area, px of the photo.
struct ElementSizes {
  double least_px = 0;
  double most_px = std::numeric_limits<double>::infinity();
};

struct PhotoElement {
  int label = 0;
  cv::Rect box;  // bounding box of its pixels, in the photo
  double area_px2 = 0;
};

struct FoundElements {
  std::vector<PhotoElement> elements;  // sorted by the upper, then by the left edge of their boxes
  std::size_t at_edge = 0;             // left out, because the photo's edge cuts them
  std::size_t too_small = 0;
  std::size_t too_large = 0;
  std::size_t too_many_pixels = 0;  // their bounding box has more than kMostElement_px2
};

/// The side of a square as large as the mean of these elements, at least one.
double mean_side_px(const std::vector<PhotoElement>& elements);

/// The largest bounding box of an element that is cut out, px².
inline constexpr int kMostElement_px2 = 16'000'000;

FoundElements find_elements(const LabelRuns& labels, const ElementSizes& sizes);

/// Room for the blurred edge of a cut-out, on each side of the element's box.
inline constexpr int kElementRim_px = 3;

/// The element cut out, with a transparent rim: straight BGRA, CV_8UC4. The opacity is half on the edge of its pixels, and
/// holes are filled. Beyond the edge the element's own colours continue, so that no gap shows. `photo`: CV_8UC4 of the size
/// of the labels.
cv::Mat cut_element(const cv::Mat& photo, const LabelRuns& labels, const PhotoElement& element);

}  // namespace tessera
