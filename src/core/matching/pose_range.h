// The range of a pose: an interval of scales and an interval of rotations; a single value is an interval, too.
// Candidates are made within the range and stay within it, so that no search result is thrown away for its pose.
// kernels/similarity.cl does the same, bit for bit.
#pragma once

#include "core/geometry/similarity.h"

namespace tessera {

/// A pose pulled to a bound lies inside by this fraction of its scale, so that rounding never puts it outside.
inline constexpr float kInsideBound = 5e-7f;
/// Tolerances for rounding: a fraction of the scale, and an angle in rad.
inline constexpr float kScaleRounding = 1e-6f;
inline constexpr float kRotationRounding_rad = 1e-5f;
/// The Cayley angle that stands for "no limit".
inline constexpr float kNoTurnLimit = 1e9f;

/// All directions within half a width of a middle direction.
struct DirectionRange {
  Vec2 middle{1, 0};  // unit
  Vec2 edge{-1, 0};   // cosine and sine of half the width; a cosine of -1: every direction

  bool all() const { return edge.x <= -1; }

  /// Whether `d`, a vector of this length, is in the range; `slack` is the sine of the angle by which it may be
  /// outside.
  bool contains(Vec2 d, float length, float slack) const {
    if (all()) return true;
    const float along = dot(d, middle);
    const float across = std::abs(cross(middle, d));
    if (edge.x > 0 && along <= 0) return false;
    return across * edge.x - along * edge.y <= slack * length;
  }

  /// The bound on the side of `d`, as a unit vector.
  Vec2 nearest_edge(Vec2 d) const {
    const float side = cross(middle, d) >= 0 ? edge.y : -edge.y;
    return {middle.x * edge.x - middle.y * side, middle.y * edge.x + middle.x * side};
  }
};

/// The directions from `min_rad` to `max_rad`.
DirectionRange direction_range(float min_rad, float max_rad);

/// The turns, as Cayley angles 2 tan(angle / 2), that keep a pose in its interval.
struct TurnLimits {
  float low = -kNoTurnLimit;
  float high = kNoTurnLimit;
};

struct PoseRange {
  float min_scale_px = 0;
  float max_scale_px = 0;
  DirectionRange rotations;

  bool contains(const Similarity& s) const {
    const float scale = s.scale();
    return scale >= min_scale_px * (1 - kScaleRounding) && scale <= max_scale_px * (1 + kScaleRounding) &&
           rotations.contains({s.a, s.b}, scale, kRotationRounding_rad);
  }

  /// Turns and scales the pose about its own centre by the least amount that brings it into the range.
  void pull_in(Similarity& s) const {
    const float scale = s.scale();
    float wanted = scale;
    if (scale < min_scale_px) wanted = min_scale_px * (1 + kInsideBound);
    if (scale > max_scale_px) wanted = max_scale_px * (1 - kInsideBound);
    if (!rotations.contains({s.a, s.b}, scale, 0)) {
      const Vec2 direction = rotations.nearest_edge({s.a, s.b});
      s.a = direction.x * wanted;
      s.b = direction.y * wanted;
    } else if (wanted != scale) {
      s.a *= wanted / scale;
      s.b *= wanted / scale;
    }
  }

  /// The turns that keep a pose of the range inside.
  TurnLimits turns(const Similarity& s) const {
    TurnLimits limits;
    if (rotations.all()) return limits;
    const Vec2 edge = rotations.edge;
    const float scale = s.scale();
    const float along = dot(Vec2{s.a, s.b}, rotations.middle);
    const float across = cross(rotations.middle, {s.a, s.b});
    const float to_high = along * edge.x + across * edge.y;  // cosine of the turn to the upper bound, times the scale
    const float to_low = along * edge.x - across * edge.y;
    // In a range of more than half a turn a bound may be near behind the pose's back, where no turn leads.
    const bool high_ahead = to_high > 0 && (edge.x > 0 || across >= 0);
    const bool low_ahead = to_low > 0 && (edge.x > 0 || across <= 0);
    if (high_ahead) limits.high = std::fmax(0.f, 2 * (along * edge.y - across * edge.x) / (scale + to_high));
    if (low_ahead) limits.low = std::fmin(0.f, 2 * (-along * edge.y - across * edge.x) / (scale + to_low));
    return limits;
  }
};

}  // namespace tessera
