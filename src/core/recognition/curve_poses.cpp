#include "core/recognition/curve_poses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "core/recognition/point_fit.h"
#include "core/recognition/query_arcs.h"

namespace tessera {
namespace {

/// Number of nearest PADs of B that are tried for each PAD of A, at each pair of widths. The distance is the root mean
/// square of the differences of the lengths' logarithms.
constexpr std::size_t kMostPairsOfPad = 6;
constexpr float kLogReach = 0.5f;
/// Range of sizes that are tried: B's extent in parts of A's, and its inverse.
constexpr float kLargestExtent = 6;
/// Largest ratio of the scale by lengths or key points to the scale that the widths of the smoothing imply.
constexpr float kPairScaleSlack = 1.2f;
/// Residuals of key points. Above the first, inner key points give a second pose; above the second, the fit gives no
/// pose.
constexpr float kSameResidual = 0.05f;
constexpr float kLargestResidual = 0.3f;
constexpr int kInnermostLevels = 2;
/// Largest distance of two arcs, and number of arcs of B that are tried for each arc of A.
constexpr float kArcPairReach = 0.04f;
constexpr std::size_t kMostPairsOfArc = 8;
/// Open curves are straight if the distance of their ends is at least this fraction of their length. They turn by 0.9
/// rad at most.
constexpr float kStraight = 0.96f;
constexpr std::size_t kMostStraight = 64;

/// A pyramid with the logarithms of its lengths.
struct LogPyramid {
  explicit LogPyramid(const PartialPyramid& partial) : partial(&partial) {
    for (int i = 0; i < partial.left_levels; ++i) left[std::size_t(i)] = std::log(partial.pyramid.left[std::size_t(i)]);
    for (int i = 0; i < partial.right_levels; ++i)
      right[std::size_t(i)] = std::log(partial.pyramid.right[std::size_t(i)]);
  }

  const PartialPyramid* partial;
  std::array<float, kMaxPadLevels> left{};
  std::array<float, kMaxPadLevels> right{};
};

std::vector<LogPyramid> log_pyramids(const QueryWidth& width) {
  return std::vector<LogPyramid>(width.pyramids.begin(), width.pyramids.end());
}

/// The distance of two pyramids by their common levels, and the logarithm of the scale, A's over B's.
struct Comparison {
  float distance = std::numeric_limits<float>::infinity();
  float log_scale = 0;
};

Comparison compared(const LogPyramid& a, const LogPyramid& b) {
  if (a.partial->pyramid.convexity * b.partial->pyramid.convexity < 0) return {};
  const int left = std::min(a.partial->left_levels, b.partial->left_levels);
  const int right = std::min(a.partial->right_levels, b.partial->right_levels);
  float sum = 0, squares = 0;
  const auto add = [&](float difference) {
    sum += difference;
    squares += difference * difference;
  };
  for (int i = 0; i < left; ++i) add(a.left[std::size_t(i)] - b.left[std::size_t(i)]);
  for (int i = 0; i < right; ++i) add(a.right[std::size_t(i)] - b.right[std::size_t(i)]);
  const float mean = sum / float(left + right);
  return {std::sqrt(std::max(0.f, squares / float(left + right) - mean * mean)), mean};
}

class PoseList {
 public:
  PoseList(const Query& a, const Query& b, int pad_levels) : a_(a), b_(b), pad_levels_(pad_levels) {}

  std::vector<Similarity> poses() && {
    std::vector<std::vector<LogPyramid>> of_b;
    for (const QueryWidth& width : b_.widths()) of_b.push_back(log_pyramids(width));
    for (const QueryWidth& width_of_a : a_.widths()) {
      const std::vector<LogPyramid> of_a = log_pyramids(width_of_a);
      for (std::size_t k = 0; k < of_b.size(); ++k) {
        const float scale = width_of_a.sigma / b_.widths()[k].sigma;
        const float extent = scale * b_.extent() / a_.extent();
        if (extent > kLargestExtent || extent < 1 / kLargestExtent) continue;
        for (const LogPyramid& pyramid : of_a) add_nearest(pyramid, of_b[k], scale);
      }
    }
    return std::move(poses_);
  }

 private:
  bool is_scale(float scale, float expected) const {
    const float slack = std::sqrt(kWidthStep) * kPairScaleSlack;
    return scale > expected / slack && scale < expected * slack;
  }

  void add_nearest(const LogPyramid& a, const std::vector<LogPyramid>& of_b, float scale) {
    near_.clear();
    for (std::size_t i = 0; i < of_b.size(); ++i) {
      const Comparison found = compared(a, of_b[i]);
      if (found.distance < kLogReach && is_scale(std::exp(found.log_scale), scale))
        near_.push_back({found.distance, i});
    }
    const std::size_t count = std::min(near_.size(), kMostPairsOfPad);
    std::partial_sort(near_.begin(), near_.begin() + std::ptrdiff_t(count), near_.end());
    for (std::size_t i = 0; i < count; ++i) add_poses(*a.partial, *of_b[near_[i].second].partial, scale);
  }

  void add_poses(const PartialPyramid& a, const PartialPyramid& b, float scale) {
    const int left = std::min(a.left_levels, b.left_levels);
    const int right = std::min(a.right_levels, b.right_levels);
    const float residual = add_pose(a, b, left, right, scale);
    if (residual < kSameResidual) return;
    add_pose(a, b, std::min(left, kInnermostLevels), std::min(right, kInnermostLevels), scale);
  }

  /// Fits a pose to the key points of these levels, adds it if it is good, and returns the residual.
  float add_pose(const PartialPyramid& a, const PartialPyramid& b, int left, int right, float scale) {
    const auto first = std::size_t(pad_levels_ - left);
    const auto count = std::size_t(left + right + 1);
    const PointFit fit = fit_points(std::span(b.pyramid.keypoint).subspan(first, count),
                                    std::span(a.pyramid.keypoint).subspan(first, count));
    if (fit.residual < kLargestResidual && is_scale(fit.query_from_shape.scale(), scale))
      poses_.push_back(fit.query_from_shape);
    return fit.residual;
  }

  const Query& a_;
  const Query& b_;
  int pad_levels_;
  std::vector<std::pair<float, std::size_t>> near_;
  std::vector<Similarity> poses_;
};

struct StraightLine {
  Vec2 from;
  Vec2 to;
  float length;
};

/// The straight open curves, the longest first, at most kMostStraight.
std::vector<StraightLine> straight_lines(const std::vector<Curve>& curves) {
  std::vector<StraightLine> lines;
  for (const Curve& curve : curves) {
    const Vec2 from = curve.points.front();
    const Vec2 to = curve.points.back();
    if (!curve.closed && norm(to - from) > kStraight * length_of(curve)) lines.push_back({from, to, norm(to - from)});
  }
  std::stable_sort(lines.begin(), lines.end(),
                   [](const StraightLine& a, const StraightLine& b) { return a.length > b.length; });
  if (lines.size() > kMostStraight) lines.resize(kMostStraight);
  return lines;
}

}  // namespace

std::vector<Similarity> curve_poses(const Query& a, const Query& b, int pad_levels) {
  return PoseList(a, b, pad_levels).poses();
}

std::vector<Similarity> arc_pair_poses(const Query& a, const Query& b) {
  const std::vector<QueryArc> of_a = query_arcs(a, 1, kArcStep);
  const std::vector<QueryArc> of_b = query_arcs(b, 1, kFineArcStep);
  std::vector<Similarity> poses;
  std::vector<std::pair<float, std::size_t>> near;
  for (const QueryArc& arc : of_a) {
    near.clear();
    for (std::size_t i = 0; i < of_b.size(); ++i) {
      const float distance = arc_distance(arc.signature, of_b[i].signature);
      if (distance < kArcPairReach) near.push_back({distance, i});
    }
    const std::size_t count = std::min(near.size(), kMostPairsOfArc);
    std::partial_sort(near.begin(), near.begin() + std::ptrdiff_t(count), near.end());
    for (std::size_t i = 0; i < count; ++i) {
      poses.push_back(fit_points(of_b[near[i].second].points, arc.points).query_from_shape);
    }
  }
  return poses;
}

std::vector<Similarity> straight_poses(const std::vector<Curve>& a, const std::vector<Curve>& b) {
  std::vector<Similarity> poses;
  const std::vector<StraightLine> of_b = straight_lines(b);
  for (const StraightLine& onto : straight_lines(a)) {
    for (const StraightLine& line : of_b) {
      const std::array<Vec2, 2> ends{line.from, line.to};
      poses.push_back(fit_points(ends, std::array{onto.from, onto.to}).query_from_shape);
      poses.push_back(fit_points(ends, std::array{onto.to, onto.from}).query_from_shape);
    }
  }
  return poses;
}

}  // namespace tessera
