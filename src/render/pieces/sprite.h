// An artwork as pixels, ready to be warped into a picture many times.
#pragma once

#include <opencv2/core.hpp>

#include "core/shape/shape.h"

namespace tessera {

/// Premultiplied BGRA, CV_8UC4. A point of the artwork frame lies at that point times px_per_artwork_px.
struct Sprite {
  cv::Mat bgra;
  double px_per_artwork_px = 1;

  std::size_t bytes() const { return bgra.total() * bgra.elemSize(); }
};

/// The sprite of the artwork's page, which was drawn as straight BGRA at any size. Nothing of it stands beyond `clip`
/// (artwork_clip.h).
Sprite sprite_of_drawing(const cv::Mat& straight_bgra, const Shape& shape, const Outline& clip);

/// The outline filled with the shape's mean colour, the page's longest side `longest_side_px` long.
Sprite sprite_of_silhouette(const Shape& shape, int longest_side_px);

/// The sprite made smaller by area averaging; it is never made larger.
Sprite shrunk(const Sprite& sprite, double px_per_artwork_px);

/// The shape's mean colour as 8-bit blue, green, red.
cv::Vec3b mean_bgr(const Shape& shape);

}  // namespace tessera
