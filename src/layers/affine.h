// Affine maps of the plane, as in SVG's matrix(). Their names say target_from_source.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

/// The map that applies `second`, then `first`.
inline cv::Matx23d joined(const cv::Matx23d& first, const cv::Matx23d& second) {
  cv::Matx23d result;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 3; ++j) {
      result(i, j) = first(i, 0) * second(0, j) + first(i, 1) * second(1, j) + (j == 2 ? first(i, 2) : 0);
    }
  }
  return result;
}

/// The inverse map; `m` must have one (its determinant is not 0).
inline cv::Matx23d inverse(const cv::Matx23d& m) {
  const double k = 1 / (m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0));
  const double a = m(1, 1) * k, b = -m(0, 1) * k, c = -m(1, 0) * k, d = m(0, 0) * k;
  return {a, b, -(a * m(0, 2) + b * m(1, 2)), c, d, -(c * m(0, 2) + d * m(1, 2))};
}

}  // namespace tessera
