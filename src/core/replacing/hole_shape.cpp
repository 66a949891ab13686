#include "core/replacing/hole_shape.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/closed_curve.h"

namespace tessera {
namespace {

/// Samples in windows lie this times as far apart as in the relaxation of a whole collage: coverage is the same, in
/// half the time (docs/decisions/2026-11-23-replacement-trials.md).
constexpr float kSpacing = 2;
constexpr int kDockPoints = 64;
constexpr int kInteriorSteps = 16;            // over the shape's field
constexpr float kInteriorPointDepth = 0.04f;  // depth of interior points; boundary samples cover nearer points

/// The length of the way through the shape, in steps as long as the field's distance to the outline.
float way_through(const ContactShape& shape, Vec2 from, Vec2 direction) {
  constexpr float kFirst = 0.05f;
  constexpr float kLeast = 0.01f;
  float way = kFirst;
  while (way < 2 * shape.radius) {
    const float distance = shape.distance(from + direction * way).value;
    if (distance > 0) break;
    way += std::max(kLeast, -distance);
  }
  return way;
}

std::vector<DockPoint> dock_points(const ContactShape& shape) {
  const std::vector<Vec2> at = resampled_closed(shape.outline.curves.front(), kDockPoints);
  std::vector<DockPoint> points;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Vec2 along = at[(i + 1) % at.size()] - at[(i + at.size() - 1) % at.size()];
    const float length = norm(along);
    if (!(length > 0)) continue;
    const Vec2 inward{-along.y / length, along.x / length};  // the interior lies on the left
    points.push_back({at[i], inward, way_through(shape, at[i], inward)});
  }
  return points;
}

std::vector<Vec2> interior_points(const ContactShape& shape) {
  const float extent = shape.field.extent;
  const float step = 2 * extent / float(kInteriorSteps);
  std::vector<Vec2> points;
  for (int j = 0; j < kInteriorSteps; ++j) {
    for (int i = 0; i < kInteriorSteps; ++i) {
      const Vec2 p{(float(i) + 0.5f) * step - extent, (float(j) + 0.5f) * step - extent};
      if (shape.distance(p).value < -kInteriorPointDepth) points.push_back(p);
    }
  }
  return points;
}

}  // namespace

HoleShape make_hole_shape(const Shape& shape) {
  HoleShape made;
  made.contact = make_contact_shape(shape, kSpacing);
  made.docks = dock_points(made.contact);
  made.interior = interior_points(made.contact);
  return made;
}

}  // namespace tessera
