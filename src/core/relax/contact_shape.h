// The data of a library shape that contacts between pieces need. Shape frame.
#pragma once

#include <array>

#include "core/field/field_lookup.h"
#include "core/relax/boundary_samples.h"
#include "core/shape/shape.h"

namespace tessera {

inline constexpr int kContactDensities = 3;

struct ContactShape {
  std::array<BoundarySamples, kContactDensities> samples;  // from dense to sparse
  Outline outline;
  ShapeField field;
  float nodes_per_unit = 0;  // of the field
  float perimeter = 0;
  float radius = 0;

  /// The samples whose steps are about 1.5 to 3 px at this scale: denser ones than the field's nodes give no new
  /// information.
  const BoundarySamples& samples_at(float scale_px) const;

  /// ShapeField::at() with its gradient.
  FieldSample distance(Vec2 p) const;
};

/// Uses outline, field, perimeter and radius of `shape`. The distances of samples are `sparser` times the usual ones.
ContactShape make_contact_shape(const Shape& shape, float sparser = 1);

inline FieldSample ContactShape::distance(Vec2 p) const {
  const float extent = field.extent;
  const Vec2 nearest{std::clamp(p.x, -extent, extent), std::clamp(p.y, -extent, extent)};
  const int last = field.distance.width() - 1;
  const float u = (nearest.x + extent) * nodes_per_unit;
  const float v = (nearest.y + extent) * nodes_per_unit;
  const int i = std::min(int(u), last - 1);
  const int j = std::min(int(v), last - 1);
  const float s = u - float(i), t = v - float(j);
  const float* q = field.distance.row(j) + i;
  const float* r = q + field.distance.width();
  const float upper = q[0] + (q[1] - q[0]) * s;
  const float lower = r[0] + (r[1] - r[0]) * s;
  FieldSample sample{
      upper + (lower - upper) * t,
      {((q[1] - q[0]) * (1 - t) + (r[1] - r[0]) * t) * nodes_per_unit, (lower - upper) * nodes_per_unit}};
  if (nearest == p) return sample;
  const Vec2 beyond = p - nearest;
  const float value = std::sqrt(sample.value * sample.value + dot(beyond, beyond));
  if (beyond.x != 0) sample.gradient.x = 0;
  if (beyond.y != 0) sample.gradient.y = 0;
  return {value, (sample.gradient * sample.value + beyond) * (1 / value)};
}

}  // namespace tessera
