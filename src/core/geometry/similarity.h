// Similarity transforms of the plane (rotation, uniform scale, translation; no mirroring).
#pragma once

#include <cmath>

#include "core/geometry/vec2.h"

namespace tessera {

/// z -> (a x - b y + tx, b x + a y + ty). A variable of this type is named target_from_source, e.g. canvas_from_shape.
struct Similarity {
  float a = 1;
  float b = 0;
  float tx = 0;
  float ty = 0;

  Vec2 apply(Vec2 p) const { return {a * p.x - b * p.y + tx, b * p.x + a * p.y + ty}; }
  Vec2 apply_direction(Vec2 d) const { return {a * d.x - b * d.y, b * d.x + a * d.y}; }
  float scale() const { return std::sqrt(a * a + b * b); }
  /// The angle in (-pi, pi], from x towards y.
  float rotation_rad() const { return std::atan2(b, a); }
  Vec2 translation() const { return {tx, ty}; }

  Similarity inverse() const {
    const float k = 1 / (a * a + b * b);
    return {a * k, -b * k, -(a * tx + b * ty) * k, (b * tx - a * ty) * k};
  }

  friend bool operator==(const Similarity&, const Similarity&) = default;
};

/// `t` followed by a uniform scaling about the origin.
inline Similarity scaled(const Similarity& t, float factor) {
  return {t.a * factor, t.b * factor, t.tx * factor, t.ty * factor};
}

}  // namespace tessera
