#include "core/recognition/boundary_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace tessera {
namespace {

/// Cosine of the largest angle between tangents of points that match: 60 degrees.
constexpr float kLeastCosine = 0.5f;
/// Points have full weight up to the first distance, in widths of the narrowest smoothing. They have no weight from the
/// second distance on, or from this fraction of the query's radius if that is farther.
constexpr float kCloseWidths = 0.67f;
constexpr float kFarWidths = 2;
constexpr float kFarOfRadius = 0.05f;
/// Limits of the fast estimate: the distance up to which points count, as a fraction of the query's radius, and the
/// number of shape points that are tested on the query's length.
constexpr float kRoughReach = 0.12f;
constexpr float kRoughPoints = 24;
constexpr int kMostStride = 6;
constexpr float kSamePose = 0.1f;  // of the query's radius: poses that differ by less end up as one
/// Added to the diagonal, as a fraction of its mean: a single straight side leaves one direction undetermined.
constexpr double kDamping = 1e-3;
constexpr float kLargestTurn_rad = 0.2f;
constexpr float kLargestGrowth = 0.2f;

/// Turns and scales the result of `pose` about the point `centre`, then shifts it.
Similarity changed(const Similarity& pose, Vec2 centre, Vec2 shift, float turn_rad, float factor) {
  const float c = std::cos(turn_rad) * factor;
  const float s = std::sin(turn_rad) * factor;
  const Vec2 t = pose.translation() - centre;
  return {c * pose.a - s * pose.b, s * pose.a + c * pose.b, c * t.x - s * t.y + centre.x + shift.x,
          s * t.x + c * t.y + centre.y + shift.y};
}

/// Sums over the points near the query. Unknowns: shift x, shift y, turn, growth; the last two as movements at `arm`.
struct NormalEquations {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  int points = 0;

  void add(Vec2 normal, Vec2 from_centre, float arm, float off, float weight) {
    const Eigen::Vector4d row{normal.x, normal.y, cross(from_centre, normal) / arm, dot(from_centre, normal) / arm};
    matrix += weight * row * row.transpose();
    right -= weight * off * row;
    ++points;
  }
  Eigen::Vector4d solved() const {
    Eigen::Matrix4d damped = matrix;
    damped.diagonal().array() += kDamping * matrix.trace() / 4;
    return damped.ldlt().solve(right);
  }
};

/// 1 on the curve, 0 from `far` on: the mean of parabolas that end at `close`, twice as far, four times as far, and so
/// on.
float closeness_within(float distance, float close, float far) {
  float sum = 0;
  int parabolas = 0;
  for (float end = close; end < 1.01f * far; end *= 2, ++parabolas) {
    sum += std::max(0.f, 1 - (distance / end) * (distance / end));
  }
  return sum / float(parabolas);
}

/// The distance from which on points have no weight.
float farthest(const Query& query) { return std::max(kFarWidths * query.least_sigma(), kFarOfRadius * query.radius()); }

NormalEquations equations_at(const Query& query, const BoundaryPoints& shape, const Similarity& pose, float reach) {
  NormalEquations equations;
  const float scale = pose.scale();
  for (std::size_t i = 0; i < shape.position.size(); ++i) {
    const Vec2 p = pose.apply(shape.position[i]);
    const CurveMap::Nearest near = query.map().nearest(p);
    if (near.distance >= reach || near.at_end) continue;
    if (dot(pose.apply_direction(shape.tangent[i]), near.tangent) < kLeastCosine * scale) continue;
    const Vec2 normal{-near.tangent.y, near.tangent.x};
    const float relative = near.distance / reach;
    const float weight = (1 - relative * relative) * (1 - relative * relative);
    equations.add(normal, p - query.centre(), query.radius(), dot(p - near.point, normal), weight);
  }
  return equations;
}

}  // namespace

Similarity refined_pose(const Query& query, const BoundaryPoints& shape, Similarity pose, int steps, float reach,
                        float least_reach, const ScaleLimits& scales) {
  for (int step = 0; step < steps; ++step) {
    const float part = steps > 1 ? float(step) / float(steps - 1) : 1.f;
    const NormalEquations equations = equations_at(query, shape, pose, reach * std::pow(least_reach / reach, part));
    if (equations.points < 4) break;
    const Eigen::Vector4d x = equations.solved();
    const float turn = std::clamp(float(x[2]) / query.radius(), -kLargestTurn_rad, kLargestTurn_rad);
    const float growth = std::clamp(float(x[3]) / query.radius(), -kLargestGrowth, kLargestGrowth);
    const float scale = pose.scale();
    const float factor = std::clamp(scale * (1 + growth), scales.least, scales.most) / scale;
    pose = changed(pose, query.centre(), {float(x[0]), float(x[1])}, turn, factor);
  }
  return pose;
}

float followed_part(const Query& query, const BoundaryPoints& shape, const Similarity& pose) {
  const float scale = pose.scale();
  const float far = farthest(query);
  float followed = 0;
  for (std::size_t i = 0; i < shape.position.size(); ++i) {
    const CurveMap::Nearest near = query.map().nearest(pose.apply(shape.position[i]));
    if (near.distance >= far || near.at_end) continue;
    const float cosine = dot(pose.apply_direction(shape.tangent[i]), near.tangent) / scale;
    if (cosine < kLeastCosine) continue;
    followed += std::min(cosine, 1.f) * closeness(query, near.distance);
  }
  return followed * shape.spacing * scale / query.length();
}

float roughly_followed(const Query& query, const BoundaryPoints& shape, const Similarity& pose) {
  const float reach = kRoughReach * query.radius();
  const float scale = pose.scale();
  const float spacing = shape.spacing * scale;
  const auto stride = std::size_t(std::clamp(query.length() / (kRoughPoints * spacing), 1.f, float(kMostStride)));
  float followed = 0;
  for (std::size_t i = 0; i < shape.position.size(); i += stride) {
    const CurveMap::Rough near = query.map().rough(pose.apply(shape.position[i]));
    if (near.squared_distance >= reach * reach) continue;
    const Vec2 tangent = pose.apply_direction(shape.tangent[i]);
    if (dot(tangent, query.map().tangent(near.point)) < kLeastCosine * scale) continue;
    followed += 1 - std::sqrt(near.squared_distance) / reach;
  }
  return followed * float(stride) * spacing / query.length();
}

float closeness(const Query& query, float distance) {
  return closeness_within(distance, kCloseWidths * query.least_sigma(), farthest(query));
}

bool is_near_any_pose(std::span<const Similarity> others, const Similarity& pose, const Query& query) {
  const Vec2 at_centre = pose.inverse().apply(query.centre());
  const float least = kSamePose * query.radius();
  return std::any_of(others.begin(), others.end(), [&](const Similarity& other) {
    const Vec2 moved = other.apply(at_centre) - query.centre();
    const float turned = norm({other.a - pose.a, other.b - pose.b}) / pose.scale() * query.radius();
    return norm(moved) < least && turned < least;
  });
}

}  // namespace tessera
