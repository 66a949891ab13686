#include "core/shape/shape_builder.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/closed_curve.h"
#include "core/geometry/polygon.h"
#include "core/shape/level_curve.h"
#include "core/shape/outline.h"
#include "core/shape/shape_field.h"

namespace tessera {
namespace {

/// The levels are made from this many points; the finest level keeps 1024.
constexpr int kFinePoints = 2048;

Outline even_outline(const TracedOutline& traced) {
  const double outer_length = traced.curves.front().length();
  Outline outline;
  for (const ClosedSpline& curve : traced.curves) {
    const int points = int(std::lround(kOuterPoints * curve.length() / outer_length));
    outline.curves.push_back(curve.even_points(std::max(points, kLeastHolePoints)));
  }
  return outline;
}

/// The position of the shape frame in the artwork frame.
struct ShapeFrame {
  Vec2 centroid_px;
  float unit_px;

  std::vector<Vec2> from_artwork(std::vector<Vec2> curve) const {
    for (Vec2& p : curve) p = (p - centroid_px) * (1 / unit_px);
    return curve;
  }
};

/// Computed from the same polygons that measure pieces, so that a piece of scale s has exactly the area s².
ShapeFrame shape_frame(const Outline& outline_px) {
  const AreaMoment sum = area_moment(outline_px);
  return {{float(sum.x / sum.area), float(sum.y / sum.area)}, float(std::sqrt(sum.area))};
}

float radius_of(const Outline& outline) {
  float radius = 0;
  for (const Vec2 p : outline.curves.front()) radius = std::max(radius, norm(p));
  return radius;
}

}  // namespace

Shape make_shape(const TracedOutline& traced, const PadParameters& pad) {
  Shape shape;
  shape.outline = even_outline(traced);
  const ShapeFrame frame = shape_frame(shape.outline);
  for (std::vector<Vec2>& curve : shape.outline.curves) curve = frame.from_artwork(std::move(curve));
  shape.perimeter = perimeter_of(shape.outline);
  shape.radius = radius_of(shape.outline);
  shape.field = make_shape_field(shape.outline);
  const std::vector<Vec2> fine_outer = frame.from_artwork(traced.curves.front().even_points(kFinePoints));
  for (std::size_t k = 0; k < kSmoothingLevels.size(); ++k) {
    shape.levels[k] = make_level_curve(fine_outer, kSmoothingLevels[k], pad);
  }
  shape.artwork.centroid_px = frame.centroid_px;
  shape.artwork.unit_px = frame.unit_px;
  return shape;
}

}  // namespace tessera
