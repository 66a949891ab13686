#include "render/pieces/artwork_clip.h"

#include <utility>

#include "core/geometry/contour.h"
#include "render/pieces/artwork_original.h"

namespace tessera {
namespace {

/// Room for parts that the outline's smoothing cut off: ends of strokes, hairs.
constexpr float kRim = 0.02f;

}  // namespace

Outline artwork_clip(const Shape& shape) {
  // contours() counts what lies beyond the grid as 0 and needs a positive level.
  constexpr float kRaise = 100;
  Grid<float> depth = shape.field.distance;
  for (float& d : depth.data()) d = kRaise - d;
  Outline clip{contours(depth, kRaise - kRim)};
  const float unit = 2 * shape.field.extent / float(depth.width() - 1);
  for (std::vector<Vec2>& curve : clip.curves) {
    for (Vec2& p : curve) p = p * unit - Vec2{shape.field.extent, shape.field.extent};
  }
  return clip;
}

Outline artwork_page_outline(const Shape& shape) {
  const Similarity shape_from_artwork = artwork_from_shape(shape.artwork).inverse();
  const float width = float(shape.artwork.width_px), height = float(shape.artwork.height_px);
  Outline page;
  page.curves.push_back({{0, 0}, {width, 0}, {width, height}, {0, height}});
  for (Vec2& p : page.curves[0]) p = shape_from_artwork.apply(p);
  return {as_drawn(shape.artwork, std::move(page.curves))};
}

}  // namespace tessera
