// Estimates how likely each pixel lies on the boundary of an element.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

/// The picture `bgr` (CV_8UC3) in CIELAB, CV_32FC3, with smooth texture and sharp edges.
cv::Mat smooth_lab(const cv::Mat& bgr);

/// The steepness of the colours after a Gaussian of `sigma_px`, CV_32F. a and b count `chroma_weight` times as much as L.
cv::Mat colour_gradient(const cv::Mat& lab, double sigma_px, double chroma_weight);

struct BoundaryKind {
  double ridge_weight = 0.5;  // the gradient has 1
  double sigma_px = 1.2;
  int joint_px = 9;  // joints up to this width count as ridges
};

/// The map, 0 to 1.5, CV_32F: steep places and narrow joints between two sides, each divided by its 95th percentile.
cv::Mat boundary_map(const cv::Mat& lab, const BoundaryKind& kind);

/// The quantile of a CV_32F map: the part `fraction` of it lies below this value.
float quantile_of(const cv::Mat& map, double fraction);

}  // namespace tessera
