// Label maps: CV_32S, 0 = nothing, 1..n = regions.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace tessera {

/// The side in px of an element in the picture that the search works on.
constexpr int kElement_px = 40;
constexpr double kElement_px2 = kElement_px * kElement_px;

/// Where each label lies and how large it is; [0] is unused.
struct RegionBox {
  cv::Rect box;
  double area_px2 = 0;
};
std::vector<RegionBox> region_boxes(const cv::Mat& labels);

/// Whether a box touches an edge of the picture.
bool reaches_edge(const cv::Rect& box, const cv::Size& picture);

/// The box with so much around it, as far as the picture goes.
cv::Rect grown_within(const cv::Rect& box, int margin_px, const cv::Size& picture);

/// How likely a region of this area is an element: 1 at the usual one, falling to both sides, from where it is
/// exp(`larger`) as large or exp(-`smaller`). `relative_area`: by the usual one.
double size_preference(double relative_area, double larger, double smaller);

/// CV_8UC3 of a picture with or without a fourth channel.
cv::Mat bgr_of(const cv::Mat& picture);

/// A structuring element for cv::morphologyEx.
cv::Mat round_window(int side_px);

/// CV_8U, 0 or 255: the largest part of `mask` that hangs together by its pixels' sides, its holes filled.
cv::Mat solid_part(const cv::Mat& mask);

/// Area by that of the convex hull of the pixels' squares; 0 of an empty mask.
double solidity_of(const cv::Mat& mask);

/// Every region reduced to its solid part; what is smaller, or less solid, is left out; numbered anew. A region within
/// a hole of another becomes part of it.
cv::Mat solid_regions(const cv::Mat& labels, double least_area_px2, double least_solidity);

}  // namespace tessera
