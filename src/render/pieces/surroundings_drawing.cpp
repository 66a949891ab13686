#include "render/pieces/surroundings_drawing.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "artwork/artwork_render.h"
#include "artwork/images/alpha.h"
#include "artwork/images/image_header.h"
#include "core/base/error.h"
#include "core/geometry/extent.h"

namespace tessera {
namespace {

/// The place of a shape's surroundings. Their page is the original's and a margin round it.
struct SurroundingsFrame {
  int page_side_px = 0;          // the longer one
  double px_per_artwork_px = 1;  // px of the page
  float margin_artwork_px = 0;
};

std::optional<SurroundingsFrame> surroundings_frame(const Artwork& artwork) {
  constexpr double kMostScale = 64, kRounded_px = 2;
  const std::optional<cv::Size2d> page = image_size_from_header(artwork.surroundings_png);
  const double around_px = 2. * artwork.surroundings_margin_px;
  if (!page || std::max(page->width, page->height) > kMaxArtworkSide_px) return {};
  const double px_per_artwork_px = (page->width - around_px) / artwork.width_px;
  if (!(px_per_artwork_px > 1 / kMostScale && px_per_artwork_px < kMostScale)) return {};
  if (std::abs(page->height - around_px - px_per_artwork_px * artwork.height_px) > kRounded_px + px_per_artwork_px)
    return {};
  return SurroundingsFrame{int(std::max(page->width, page->height)), px_per_artwork_px,
                           float(artwork.surroundings_margin_px / px_per_artwork_px)};
}

/// The part of the picture that the page covers.
Extent page_extent(const Artwork& artwork, float margin, const PieceDrawing& drawing) {
  const Vec2 page{float(artwork.width_px) + 2 * margin, float(artwork.height_px) + 2 * margin};
  std::vector<Vec2> corners{{0, 0}, {page.x, 0}, {0, page.y}, page};
  if (drawing.mirrored_at_px) {
    for (Vec2& p : corners) p.x = 2 * *drawing.mirrored_at_px - p.x;
  }
  return extent_of(corners, drawing.picture_from_artwork);
}

/// Whether the numbers are those of a picture; a library may claim others.
bool is_drawable(const Extent& page) {
  constexpr float kMost_px = 1e7F;
  return page.low.x > -kMost_px && page.low.y > -kMost_px && page.high.x < kMost_px && page.high.y < kMost_px;
}

}  // namespace

std::optional<PieceDrawing> surroundings_drawing(const Placement& placement, const Shape& shape, double picture_px) {
  const std::optional<SurroundingsFrame> frame = surroundings_frame(shape.artwork);
  if (!frame) return {};
  const float margin = frame->margin_artwork_px;
  PieceDrawing drawing;
  // The frame of the page is that of the artwork, moved by the margin.
  Similarity& from_page = drawing.picture_from_artwork = picture_from_artwork(placement, shape.artwork, picture_px);
  const Vec2 corner = from_page.apply({-margin, -margin});
  from_page.tx = corner.x;
  from_page.ty = corner.y;
  if (shape.artwork.mirrored) drawing.mirrored_at_px = shape.artwork.centroid_px.x + margin;
  const Extent page = page_extent(shape.artwork, margin, drawing);
  if (!is_drawable(page)) return {};
  const Window box = nodes_round(page, {}, 0);
  drawing.box = {box.x0, box.y0, box.width(), box.height()};
  drawing.sprite_side_px = frame->page_side_px;
  return drawing;
}

Sprite surroundings_sprite(const Artwork& artwork, Drawers& drawers) {
  try {
    const std::string name = artwork.path + " (surroundings)";
    const cv::Mat page = drawers.decode_png(artwork.surroundings_png, name, kMaxArtworkSide_px);
    return {premultiplied(page), surroundings_frame(artwork)->px_per_artwork_px};
  } catch (const InputError&) {
    return {cv::Mat::zeros(1, 1, CV_8UC4), 1};
  }
}

}  // namespace tessera
