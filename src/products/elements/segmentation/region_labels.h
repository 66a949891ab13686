// Label maps: CV_32S, 0 = nothing, 1..n = regions.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace tessera {

/// The side of an element, in px of the picture in which the search works.
constexpr int kElement_px = 40;
constexpr double kElement_px2 = kElement_px * kElement_px;

/// Place and size of a region.
struct RegionBox {
  cv::Rect box;
  double area_px2 = 0;
};
std::vector<RegionBox> region_boxes(const cv::Mat& labels);

/// Whether a box touches an edge of the picture.
bool reaches_edge(const cv::Rect& box, const cv::Size& picture);

/// The box with a margin around it, cut off at the picture's edges.
cv::Rect grown_within(const cv::Rect& box, int margin_px, const cv::Size& picture);

/// How likely a region of this area is an element: 1 from exp(-`smaller`) to exp(`larger`) times the usual area, and
/// falling beyond on both sides. `relative_area`: area divided by the usual one.
double size_preference(double relative_area, double larger, double smaller);

/// The first three channels of a picture, CV_8UC3.
cv::Mat bgr_of(const cv::Mat& picture);

/// A round structuring element for cv::morphologyEx.
cv::Mat round_window(int side_px);

/// The largest part of `mask` that is connected by sides of pixels, with its holes filled: CV_8U, 0 or 255.
cv::Mat solid_part(const cv::Mat& mask);

/// The area divided by the area of the convex hull of the pixels' squares; 0 for an empty mask.
double solidity_of(const cv::Mat& mask);

/// Reduces every region to its solid part, leaves out regions that are smaller or less solid, and numbers the rest again. A
/// region inside a hole of another one becomes part of it.
cv::Mat solid_regions(const cv::Mat& labels, double least_area_px2, double least_solidity);

}  // namespace tessera
