#include "io/result/artwork_clip.h"

#include "core/geometry/contour.h"

namespace tessera::io {
namespace {

/// Room for what the outline's smoothing left out: ends of strokes, hairs.
constexpr float kRim = 0.02f;

}  // namespace

Outline artwork_clip(const Shape& shape) {
  // contours() takes what lies beyond the grid as 0 and wants a positive level.
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

}  // namespace tessera::io
