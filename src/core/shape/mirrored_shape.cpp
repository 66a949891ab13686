#include "core/shape/mirrored_shape.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace tessera {
namespace {

Vec2 mirrored(Vec2 p) { return {-p.x, p.y}; }

/// The mirrored curve, run backwards; the first point stays the first.
std::vector<Vec2> mirrored_curve(std::vector<Vec2> curve) {
  for (Vec2& p : curve) p = mirrored(p);
  if (!curve.empty()) std::reverse(curve.begin() + 1, curve.end());
  return curve;
}

/// Left and right are exchanged. The convexity stays, as side and direction both change.
ArclengthPyramid mirrored_pyramid(ArclengthPyramid pyramid, int pad_levels) {
  std::swap(pyramid.left, pyramid.right);
  const auto end = pyramid.keypoint.begin() + 2 * pad_levels + 1;
  std::reverse(pyramid.keypoint.begin(), end);
  std::transform(pyramid.keypoint.begin(), end, pyramid.keypoint.begin(), mirrored);
  return pyramid;
}

/// Samples lie at regular points, the first one at the first point.
LevelCurve mirrored_level(LevelCurve level, int pad_levels) {
  level.points = mirrored_curve(std::move(level.points));
  for (ArclengthPyramid& pyramid : level.samples) pyramid = mirrored_pyramid(pyramid, pad_levels);
  if (!level.samples.empty()) std::reverse(level.samples.begin() + 1, level.samples.end());
  return level;
}

}  // namespace

Shape mirror_image(Shape shape, int pad_levels) {
  for (std::vector<Vec2>& curve : shape.outline.curves) curve = mirrored_curve(std::move(curve));
  Grid<float>& distance = shape.field.distance;
  for (int y = 0; y < distance.height(); ++y) std::reverse(distance.row(y), distance.row(y) + distance.width());
  for (LevelCurve& level : shape.levels) level = mirrored_level(std::move(level), pad_levels);
  shape.colour_grid = mirrored(shape.colour_grid);
  shape.artwork.mirrored = !shape.artwork.mirrored;
  return shape;
}

}  // namespace tessera
