// An artwork as pixels that can be warped into a picture many times.
#pragma once

#include <opencv2/core.hpp>

#include "core/shape/shape.h"

namespace tessera {

/// Premultiplied BGRA, CV_8UC4. The point p of the artwork frame lies at p times px_per_artwork_px.
struct Sprite {
  cv::Mat bgra;
  double px_per_artwork_px = 1;

  std::size_t bytes() const { return bgra.total() * bgra.elemSize(); }
};

/// The sprite of the artwork's page, which was drawn as straight BGRA at any size. Everything outside `clip`
/// (artwork_clip.h) is cut off.
Sprite sprite_of_drawing(const cv::Mat& straight_bgra, const Shape& shape, const Outline& clip);

/// The outline filled with the shape's mean colour. The longest side of the page is `longest_side_px`.
Sprite sprite_of_silhouette(const Shape& shape, int longest_side_px);

/// The sprite scaled down by area averaging; it is never enlarged.
Sprite shrunk(const Sprite& sprite, double px_per_artwork_px);

/// The shape's mean colour as 8-bit blue, green, red.
cv::Vec3b mean_bgr(const Shape& shape);

}  // namespace tessera
