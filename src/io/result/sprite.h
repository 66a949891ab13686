// An artwork as pixels, ready to be warped into a picture many times.
#pragma once

#include <opencv2/core.hpp>

#include "core/shape/shape.h"

namespace tessera::io {

/// Premultiplied BGRA, CV_8UC4. A point of the artwork frame lies at that point times px_per_artwork_px.
struct Sprite {
  cv::Mat bgra;
  double px_per_artwork_px = 1;
};

enum class SpriteSource { original, thumbnail };

/// The artwork with its longest side `longest_side_px` long or less. The original where it can be had and drawn; else the
/// thumbnail; else the outline filled with the shape's mean colour. Clipped (artwork_clip.h).
Sprite make_sprite(const Shape& shape, int longest_side_px, SpriteSource source);

/// Smaller by area averaging; never larger.
Sprite shrunk(const Sprite& sprite, double px_per_artwork_px);

/// The shape's mean colour as 8-bit blue, green, red.
cv::Vec3b mean_bgr(const Shape& shape);

}  // namespace tessera::io
