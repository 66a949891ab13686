#include "render/pieces/sprite.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "artwork/images/alpha.h"
#include "artwork/images/colour_conversion.h"
#include "core/geometry/rasterise.h"
#include "render/pieces/artwork_original.h"

namespace tessera {
namespace {

int page_side(const Artwork& artwork) { return std::max(1, std::max(artwork.width_px, artwork.height_px)); }

}  // namespace

Sprite sprite_of_drawing(const cv::Mat& straight_bgra, const Shape& shape, const Outline& clip) {
  const int side = std::max(straight_bgra.cols, straight_bgra.rows);
  const double scale = double(side) / page_side(shape.artwork);
  const Similarity sprite_from_shape = scaled(artwork_from_shape(shape.artwork), float(scale));
  cv::Mat bgra(straight_bgra.size(), CV_8UC4, cv::Scalar());
  const Outline drawn{as_drawn(shape.artwork, clip.curves)};
  for (const Span& span : fill_spans(drawn, sprite_from_shape, {0, 0, bgra.cols, bgra.rows})) {
    const cv::Rect part(span.x0, span.y, span.x1 - span.x0, 1);
    premultiplied(straight_bgra(part)).copyTo(bgra(part));
  }
  return {bgra, scale};
}

Sprite sprite_of_silhouette(const Shape& shape, int longest_side_px) {
  const double scale = double(longest_side_px) / page_side(shape.artwork);
  const Similarity sprite_from_shape = scaled(artwork_from_shape(shape.artwork), float(scale));
  const cv::Vec3b colour = mean_bgr(shape);
  cv::Mat bgra(std::max(1, int(shape.artwork.height_px * scale + 0.5)),
               std::max(1, int(shape.artwork.width_px * scale + 0.5)), CV_8UC4, cv::Scalar());
  const Outline drawn{as_drawn(shape.artwork, shape.outline.curves)};
  for (const Span& span : fill_spans(drawn, sprite_from_shape, {0, 0, bgra.cols, bgra.rows})) {
    cv::Vec4b* row = bgra.ptr<cv::Vec4b>(span.y);
    std::fill(row + span.x0, row + span.x1, cv::Vec4b(colour[0], colour[1], colour[2], 255));
  }
  return {bgra, scale};
}

Sprite shrunk(const Sprite& sprite, double px_per_artwork_px) {
  const double factor = px_per_artwork_px / sprite.px_per_artwork_px;
  if (factor >= 1) return sprite;
  const cv::Size size(std::max(1, cvRound(sprite.bgra.cols * factor)), std::max(1, cvRound(sprite.bgra.rows * factor)));
  Sprite small;
  cv::resize(sprite.bgra, small.bgra, size, 0, 0, cv::INTER_AREA);
  small.px_per_artwork_px =
      sprite.px_per_artwork_px * std::max(size.width, size.height) / std::max(sprite.bgra.cols, sprite.bgra.rows);
  return small;
}

cv::Vec3b mean_bgr(const Shape& shape) { return bgr_of(Lab{shape.mean_lab[0], shape.mean_lab[1], shape.mean_lab[2]}); }

}  // namespace tessera
