#include "bench/inputs/shape_variation.h"

#include <algorithm>
#include <cmath>

#include "core/shape/shape_builder.h"

namespace tessera {
namespace {

Vec2 moved(Vec2 p, const ShapeVariation& variation) {
  if (variation.mirrored) p.x = -p.x;
  const Vec2 along{std::cos(variation.angle_rad), std::sin(variation.angle_rad)};
  return along * (dot(along, p) * variation.factor) + Vec2{-along.y, along.x} * (cross(along, p) / variation.factor);
}

/// The points become the spline's control points: the spline differs from the polygon by a fraction of their spacing,
/// far below the finest smoothing level. A mirrored curve is reversed, so that its interior stays on the left.
ClosedSpline varied_curve(std::vector<Vec2> curve, const ShapeVariation& variation) {
  if (variation.mirrored) std::reverse(curve.begin(), curve.end());
  Eigen::Matrix2Xd control(2, Eigen::Index(curve.size()));
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const Vec2 p = moved(curve[i], variation);
    control.col(Eigen::Index(i)) << p.x, p.y;
  }
  return ClosedSpline(std::move(control));
}

}  // namespace

Shape varied_shape(const Shape& shape, const ShapeVariation& variation, const PadParameters& pad) {
  TracedOutline varied;
  for (const std::vector<Vec2>& curve : shape.outline.curves) varied.curves.push_back(varied_curve(curve, variation));
  Shape result = make_shape(varied, pad);
  result.name = shape.name;
  result.mean_lab = shape.mean_lab;
  result.artwork = {};
  return result;
}

}  // namespace tessera
