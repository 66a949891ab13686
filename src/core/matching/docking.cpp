#include "core/matching/docking.h"

#include <algorithm>
#include <cmath>

#include "core/base/portable_math.h"
#include "core/settings/tuning.h"

namespace tessera {
namespace {

/// Sums over the key points of both pyramids, less their means, for the least squares fit.
struct PointMoments {
  Vec2 product;  // sum of target times conjugate shape point: real and imaginary part
  float shape_spread = 1e-12f;
  float target_spread = 0;
  Vec2 shape_mean;
  Vec2 target_mean;
  float count = 0;
};

PointMoments moments(const Keypoints& shape, const ArclengthPyramid& target, int begin, int end) {
  PointMoments m;
  m.count = float(end - begin);
  Vec2 shape_sum;
  Vec2 target_sum;
  for (int i = begin; i < end; ++i) {
    shape_sum = shape_sum + shape[i];
    target_sum = target_sum + target.keypoint[i];
  }
  m.shape_mean = shape_sum * (1 / m.count);
  m.target_mean = target_sum * (1 / m.count);
  for (int i = begin; i < end; ++i) {
    const Vec2 q = shape[i] - m.shape_mean;
    const Vec2 t = target.keypoint[i] - m.target_mean;
    m.product.x += dot(q, t);
    m.product.y += cross(q, t);
    m.shape_spread += dot(q, q);
    m.target_spread += dot(t, t);
  }
  return m;
}

struct Fit {
  Similarity pose;
  float residual;  // mean square, px²
};

/// The best pose within the range. False if it would have to be turned by more than a right angle.
bool fit_within(const PoseRange& poses, const PointMoments& m, Fit& fit) {
  Vec2 product = m.product;
  if (!poses.rotations.contains(product, norm(product), 0)) {
    const Vec2 direction = poses.rotations.nearest_edge(product);
    const float along = dot(product, direction);
    if (along <= 0) return false;
    product = {direction.x * along, direction.y * along};
  }
  Similarity& s = fit.pose;
  s.a = product.x / m.shape_spread;
  s.b = product.y / m.shape_spread;
  const float best_scale = s.scale();
  poses.pull_in(s);
  // The explained part of the spread: the square of the best scale, less the square of the scale's deviation from it.
  const float off = s.scale() - best_scale;
  fit.residual = (m.target_spread - (best_scale * best_scale - off * off) * m.shape_spread) / m.count;
  return true;
}

}  // namespace

Alignment align_pyramids(const Keypoints& shape, const ArclengthPyramid& target, int levels, ScaleRange scales,
                         std::span<const Stance> stances) {
  const int least_level = std::max(0, levels - kAlignmentLevels);
  for (int level = levels - 1; level >= least_level; --level) {
    const PointMoments m = moments(shape, target, levels - 1 - level, levels + 2 + level);
    Fit best;
    best.residual = kAlignmentTolerance * kAlignmentUnit_px * std::sqrt(m.target_spread / m.count);
    Alignment aligned;
    for (std::uint32_t k = 0; k < stances.size(); ++k) {
      Fit fit;
      if (!fit_within(stances[k].poses, m, fit) || fit.residual > best.residual) continue;
      const float scale = fit.pose.scale();
      if (scale < scales.low || scale > scales.high) continue;
      if (aligned.valid && fit.residual == best.residual) continue;
      best = fit;
      aligned = {fit.pose, k, true};
    }
    if (!aligned.valid) continue;
    Similarity& s = aligned.canvas_from_shape;
    s.tx = m.target_mean.x - (s.a * m.shape_mean.x - s.b * m.shape_mean.y);
    s.ty = m.target_mean.y - (s.b * m.shape_mean.x + s.a * m.shape_mean.y);
    return aligned;
  }
  return {};
}

TangentDraw draw_tangent(const MatchingContext& context, const TargetSample& sample, std::uint32_t draw,
                         std::span<const std::uint32_t> near, const Deck& deck) {
  const std::uint64_t key =
      mix_bits(context.seed ^ mix_bits(mix_bits((std::uint64_t(edge_number(sample.id)) << 32) | sample.pass) ^ draw));
  const std::uint64_t more = mix_bits(key);
  TangentDraw result;
  const StanceTable& stances = context.stances;
  const std::uint32_t open = stances.open_shapes();
  if (open == 0) return result;
  result.drawn = true;
  const std::uint64_t shape_bits = key >> 32;
  if (near.empty() || draw % kAnyColourDraws == 0) {
    const auto place = [&](std::size_t all) { return std::uint32_t((shape_bits * all) >> 32); };
    result.shape = stances.open_shape(deck.open.empty() ? place(open) : deck.open[place(deck.open.size())]);
  } else {
    const std::uint64_t squared = (shape_bits * shape_bits) >> 32;
    const auto place = [&](std::size_t all) { return std::size_t((squared * all) >> 32); };
    result.shape = ShapeId(near[deck.near.empty() ? place(near.size()) : deck.near[place(deck.near.size())]]);
  }
  const StanceList& list = stances.list(result.shape);
  result.stance = list.first + std::uint32_t(((more & 0xffffffffull) * list.count) >> 32);
  result.point_bits = std::uint32_t(key & 0xffffffffull);
  const Stance stance = sized_at(context, stances[result.stance], sample.position);
  result.scale_px =
      stance.poses.min_scale_px * portable_exp2(unit_float(std::uint32_t(more >> 32)) * stance.log2_scale_ratio);
  return result;
}

int docked_point(const ShapeModel& shape, const TangentDraw& draw, const TargetSample& sample,
                 const DirectionRange& docked_rotations) {
  const auto chosen_of = [&](std::uint32_t count) {
    return std::uint32_t((std::uint64_t(draw.point_bits) * count) >> 32);
  };
  if (docked_rotations.all()) return int(chosen_of(kBoundaryPoints));
  const auto docks = [&](const Vec2& u) {
    return docked_rotations.contains({dot(u, sample.tangent), cross(u, sample.tangent)}, 1, 0);
  };
  const std::uint32_t count = std::uint32_t(std::count_if(shape.tangent.begin(), shape.tangent.end(), docks));
  std::uint32_t before = chosen_of(count);
  for (int i = 0; count > 0 && i < kBoundaryPoints; ++i) {
    if (docks(shape.tangent[i]) && before-- == 0) return i;
  }
  return kNoPoint;
}

Similarity tangent_docking(const ShapeModel& shape, int boundary_point, float scale_px, const TargetSample& sample,
                           const PoseRange& poses) {
  const Vec2 u = shape.tangent[boundary_point];
  const Vec2 p = shape.boundary[boundary_point];
  Similarity s;
  // Target tangent times the conjugate of the shape's tangent: the rotation from the shape to the target.
  s.a = dot(u, sample.tangent) * scale_px;
  s.b = cross(u, sample.tangent) * scale_px;
  if (!poses.rotations.all()) poses.pull_in(s);  // the scale was drawn within its range
  s.tx = sample.position.x - (s.a * p.x - s.b * p.y);
  s.ty = sample.position.y - (s.b * p.x + s.a * p.y);
  return s;
}

float docking_key(const ShapeModel& shape, const Similarity& canvas_from_shape, const FieldView& field,
                  float max_scale_px) {
  const float scale = canvas_from_shape.scale();
  const float hopeless_px = std::max(kHopelessDocking_px, kHopelessDocking * scale);
  const float near_px = std::max(kNearDocking_px, kNearDocking * scale);
  // One look-up rejects most dockings: where the shape's disc does not fit, the piece does not fit.
  if (field_value(field, canvas_from_shape.apply(shape.disc_centre)) < shape.disc_radius * scale - hopeless_px) {
    return kRejectedDocking;
  }
  constexpr int kPoints = kBoundaryPoints / kCoarseStride;
  int hits = 0;
  int bad = 0;
  for (int i = 0; i < kBoundaryPoints; i += kCoarseStride) {
    const float d = field_value(field, canvas_from_shape.apply(shape.boundary[i]));
    if (d < -hopeless_px) return kRejectedDocking;
    if (d < -near_px) {
      if (++bad > kMostBadPoints) return kRejectedDocking;
    } else if (d < near_px) {
      ++hits;
    }
  }
  int covered = 0;
  for (std::size_t i = 0; i < shape.interior.size(); i += kInteriorStride) {
    if (field_value(field, canvas_from_shape.apply(shape.interior[i])) < 0) ++covered;
  }
  const float interior = shape.interior.empty() ? 0.f : kCoveredCost * float(covered) / float(shape.interior.size());
  const float fit = (float(hits) - kBadPointCost * float(bad)) / float(kPoints) - interior;
  // Large pieces first: they are harder to place later.
  return fit * std::sqrt(std::sqrt(scale / max_scale_px));
}

}  // namespace tessera
