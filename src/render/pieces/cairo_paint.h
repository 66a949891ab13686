// Paints curves into a part of a picture. The result does not depend on how the picture is divided into parts.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "core/geometry/similarity.h"
#include "core/geometry/vec2.h"

namespace tessera {

using Curves = std::vector<std::vector<Vec2>>;  // closed

/// The part of each pixel in the picture's `window` that the curves fill (even-odd): 0 to 255, CV_8U.
cv::Mat filled_coverage(const Curves& curves, const Similarity& picture_from_curves, const cv::Rect& window);

/// Curves and their place in the picture.
struct PlacedCurves {
  const Curves* curves = nullptr;
  Similarity picture_from_curves;
};

/// The coverage of many filled curves. Each is filled by itself and laid over the ones before.
cv::Mat filled_coverage(const std::vector<PlacedCurves>& many, const cv::Rect& window);

/// Draws a line along the curves, `width_px` wide in the picture, over `bgra` (premultiplied), whose upper left pixel is
/// the picture's pixel `corner`.
void draw_line(const PlacedCurves& curves, double width_px, const cv::Vec3b& bgr, cv::Point corner, cv::Mat bgra);

}  // namespace tessera
