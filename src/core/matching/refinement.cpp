#include "core/matching/refinement.h"

#include <algorithm>
#include <cmath>

#include "core/base/lanes.h"
#include "core/settings/tuning.h"

namespace tessera {
namespace {

struct PoseLimits {
  float low;
  float high;

  float limited(float x) const { return x < low ? low : x > high ? high : x; }
};

/// A symmetric 4 x 4 system. Unknowns: shift x, shift y, growth, rotation; the last two as movements at `arm_px`.
struct NormalEquations {
  float m[4][4] = {};
  float g[4] = {};

  /// Solves (M + damping) x = -g by L D L^T, in place, with x[2] and x[3] clamped to their limits. Each clamp happens
  /// before the unknowns that depend on it are computed, so that these fit the clamped value best.
  void solve(float (&x)[4], const PoseLimits& growth, const PoseLimits& turn) {
    const float trace = m[0][0] + m[1][1] + m[2][2] + m[3][3];
    for (int r = 0; r < 4; ++r) m[r][r] += kDamping * trace + kLeastDamping;
    m[2][2] += kGrowthDamping * trace;
    float d[4];
    for (int r = 0; r < 4; ++r) {
      for (int c = 0; c < r; ++c) {
        float sum = m[r][c];
        for (int k = 0; k < c; ++k) sum -= m[r][k] * m[c][k] * d[k];
        m[r][c] = sum / d[c];
      }
      float sum = m[r][r];
      for (int k = 0; k < r; ++k) sum -= m[r][k] * m[r][k] * d[k];
      d[r] = sum;
    }
    for (int r = 0; r < 4; ++r) {
      float sum = -g[r];
      for (int k = 0; k < r; ++k) sum -= m[r][k] * x[k];
      x[r] = sum;
    }
    for (int r = 0; r < 4; ++r) x[r] = x[r] / d[r];
    for (int r = 3; r >= 0; --r) {
      for (int k = r + 1; k < 4; ++k) x[r] -= m[k][r] * x[k];
      if (r == 3) x[r] = turn.limited(x[r]);
      if (r == 2) x[r] = growth.limited(x[r]);
    }
  }
};

/// 16 boundary points on the canvas, with the field at each.
struct PlacedPoints {
  Lanes x, y, value, gradient_x, gradient_y;

  int nearer_than(float radius) const {
    return int(std::count_if(value.begin(), value.end(), [&](float v) { return v <= radius; }));
  }
};

/// Block number `block` of 16 boundary points, when every `stride`-th point is used.
PlacedPoints placed_points(const Similarity& s, const ShapeModel& shape, const FieldView& field, int block,
                           int stride) {
  PlacedPoints points;
  for (int i = 0; i < kLanes; ++i) {
    const Vec2 z = s.apply(shape.boundary[(block * kLanes + i) * stride]);
    const FieldSample f = field_sample(field, z);
    points.x[i] = z.x;
    points.y[i] = z.y;
    points.value[i] = f.value;
    points.gradient_x[i] = f.gradient.x;
    points.gradient_y[i] = f.gradient.y;
  }
  return points;
}

/// The weight of each point; 0 for points farther than `radius` from the boundary.
Lanes weights_of(const PlacedPoints& points, float radius, float overlap_weight) {
  Lanes weights;
  for (int i = 0; i < kLanes; ++i) {
    const float q = points.value[i] / radius;
    const float fade = (1 - q * q) * (1 - q * q);
    const float inside = points.value[i] <= radius ? fade : 0.f;
    weights[i] = points.value[i] >= 0 ? inside : overlap_weight;
  }
  return weights;
}

/// NormalEquations in 16 lanes: point i of the set is added to lane i % 16.
struct LaneEquations {
  Lanes m[4][4] = {};
  Lanes g[4] = {};

  void add(const PlacedPoints& points, const Lanes& weights, Vec2 centre, float arm) {
    Lanes j[4] = {points.gradient_x, points.gradient_y, {}, {}};
    for (int i = 0; i < kLanes; ++i) {
      const float ux = points.x[i] - centre.x;
      const float uy = points.y[i] - centre.y;
      j[2][i] = (points.gradient_x[i] * ux + points.gradient_y[i] * uy) / arm;
      j[3][i] = (points.gradient_y[i] * ux - points.gradient_x[i] * uy) / arm;
    }
    for (int r = 0; r < 4; ++r) {
      Lanes weighted;
      for (int i = 0; i < kLanes; ++i) weighted[i] = weights[i] * j[r][i];
      add_products(g[r], weighted, points.value);
      for (int c = 0; c <= r; ++c) add_products(m[r][c], weighted, j[c]);
    }
  }

  NormalEquations sums() const {
    NormalEquations equations;
    for (int r = 0; r < 4; ++r) {
      equations.g[r] = sum_of_lanes(g[r]);
      for (int c = 0; c <= r; ++c) equations.m[r][c] = sum_of_lanes(m[r][c]);
    }
    return equations;
  }

 private:
  static void add_products(Lanes& sums, const Lanes& a, const Lanes& b) {
    for (int i = 0; i < kLanes; ++i) sums[i] += a[i] * b[i];
  }
};

/// Turns and scales about the piece's own centre, then shifts. The rotation is the Cayley form of `angle`, which needs
/// no sine.
void move(Similarity& s, float dx, float dy, float growth, float angle) {
  const float t = 0.5f * angle;
  const float k = (1 + growth) / (1 + t * t);
  const float c = k * (1 - t * t);
  const float n = k * (2 * t);
  const float a = s.a * c - s.b * n;
  const float b = s.b * c + s.a * n;
  s.a = a;
  s.b = b;
  s.tx += dx;
  s.ty += dy;
}

}  // namespace

void descend(Similarity& s, const ShapeModel& shape, const FieldView& field, const Descent& descent,
             const PoseRange& poses) {
  const int stride = descent.all_points ? 1 : kMediumStride;
  static_assert(kBoundaryPoints % (kMediumStride * kLanes) == 0);
  for (int step = 0; step < descent.steps; ++step) {
    const float progress = descent.steps > 1 ? float(step) / float(descent.steps - 1) : 1.f;
    const float radius = descent.first_radius_px + (descent.last_radius_px - descent.first_radius_px) * progress;
    const float scale = s.scale();
    const float arm = shape.radius * scale * kArm;
    LaneEquations lanes;
    int drawn = 0;
    for (int block = 0; block * kLanes * stride < kBoundaryPoints; ++block) {
      const PlacedPoints points = placed_points(s, shape, field, block, stride);
      const int nearer = points.nearer_than(radius);
      if (nearer == 0) continue;
      lanes.add(points, weights_of(points, radius, descent.overlap_weight), s.translation(), arm);
      drawn += nearer;
    }
    if (drawn < kLeastDrawnPoints) return;
    NormalEquations equations = lanes.sums();
    float x[4];
    const TurnLimits turns = poses.turns(s);
    equations.solve(x, {(poses.min_scale_px / scale - 1) * arm, (poses.max_scale_px / scale - 1) * arm},
                    {turns.low * arm, turns.high * arm});
    const float largest = std::max(std::max(std::abs(x[0]), std::abs(x[1])), std::max(std::abs(x[2]), std::abs(x[3])));
    if (largest > radius) {
      for (float& v : x) v = v * (radius / largest);
    }
    move(s, x[0], x[1], x[2] / arm, x[3] / arm);
    poses.pull_in(s);
  }
}

/// A step moves the piece by at most the radius along each axis, and a point at the rim by growth and rotation. Each of
/// these is at most the radius at the arm, and both together a little more than their sum.
float longest_way_px(const Descent& descent, float least_radius_px) {
  const float radius_px = std::max(descent.first_radius_px, descent.last_radius_px);
  const float at_rim_px = radius_px / kArm;
  return float(descent.steps) * (1.4143f * radius_px + 2 * at_rim_px + at_rim_px * at_rim_px / least_radius_px);
}

float depth_px(const Similarity& canvas_from_shape, const ShapeModel& shape, const FieldView& field) {
  float deepest = 0;
  for (const Vec2& p : shape.boundary) {
    deepest = std::max(deepest, -field_value(field, canvas_from_shape.apply(p)));
  }
  for (const Vec2& p : shape.interior) {
    const float d = -field_value(field, canvas_from_shape.apply(p));
    if (d > 0) deepest = std::max(deepest, d + kInteriorDepth_px);
  }
  return deepest;
}

bool refine(Similarity& s, const ShapeModel& shape, const FieldView& field, const PoseRange& poses,
            float hard_depth_px) {
  Descent approach = kApproach;
  approach.first_radius_px = std::max(kApproach.first_radius_px, kApproachRadius * s.scale());
  descend(s, shape, field, approach, poses);
  descend(s, shape, field, kCloseFit, poses);
  float depth = depth_px(s, shape, field);
  for (int push = 0; push < kPushSteps && depth > hard_depth_px; ++push) {
    if (depth > kMaxPushDepth_px) return false;
    if (push > 0) {
      s.a *= kPushShrink;
      s.b *= kPushShrink;
      poses.pull_in(s);
    }
    descend(s, shape, field, kPush, poses);
    depth = depth_px(s, shape, field);
  }
  return depth <= hard_depth_px && poses.contains(s);
}

bool grow_step(Similarity& s, const ShapeModel& shape, const FieldView& field, const PoseRange& poses,
               float hard_depth_px) {
  Similarity larger = s;
  larger.a *= kGrowStep;
  larger.b *= kGrowStep;
  poses.pull_in(larger);
  descend(larger, shape, field, kGrow, poses);
  const bool grown = larger.scale() > s.scale() * kLeastGrowth;
  if (!grown || depth_px(larger, shape, field) > hard_depth_px) return false;
  s = larger;
  return true;
}

}  // namespace tessera
