// How likely it is that a pixel lies on the boundary of an element.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

/// `bgr`: CV_8UC3. CIE Lab as CV_32FC3, its texture smoothed but not its edges.
cv::Mat smooth_lab(const cv::Mat& bgr);

/// Steepness of the colours after a Gaussian of `sigma_px`, CV_32F; a and b count 1.5 times as much as L.
cv::Mat colour_gradient(const cv::Mat& lab, double sigma_px, double chroma_weight);

struct BoundaryKind {
  double ridge_weight = 0.5;  // beside the gradient's 1
  double sigma_px = 1.2;
  int joint_px = 9;  // joints up to this width are ridges
};

/// 0..1.5, CV_32F: steep places and narrow joints between two sides, each by its 95th percentile.
cv::Mat boundary_map(const cv::Mat& lab, const BoundaryKind& kind);

/// The value below which the part `fraction` of a CV_32F map lies.
float quantile_of(const cv::Mat& map, double fraction);

}  // namespace tessera
