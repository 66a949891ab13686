#include "master/rules/open_shapes.h"

#include <algorithm>
#include <iterator>

#include "core/matching/size_schedule.h"
#include "core/settings/tuning.h"

namespace tessera::master {
namespace {

/// Whether the pose leaves `poses` only by rounding: files of results write px and degrees with three decimals.
bool is_rounded_out_of(const PoseRange& poses, Similarity pose) {
  constexpr float kRounding_px = 0.0006f;
  constexpr float kRounding_rad = 1e-5f;
  const Vec2 written{pose.a, pose.b};
  poses.pull_in(pose);
  return norm(Vec2{pose.a, pose.b} - written) < kRounding_px + kRounding_rad * pose.scale();
}

/// `all` without `some`; both lists are ascending, as in the next function.
std::vector<ShapeId> without(const std::vector<ShapeId>& all, const std::vector<ShapeId>& some) {
  std::vector<ShapeId> rest;
  std::set_difference(all.begin(), all.end(), some.begin(), some.end(), std::back_inserter(rest));
  return rest;
}

std::vector<ShapeId> joined(const std::vector<ShapeId>& a, const std::vector<ShapeId>& b) {
  std::vector<ShapeId> both;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

}  // namespace

OpenShapes::OpenShapes(const MatchingContext& context, const PieceSettings& pieces, const Scoring& scoring,
                       ShapeSource& shapes, float size_factor)
    : context_(context),
      all_stances_(context.stances),
      fit_all_(pieces.fit_all),
      scoring_(scoring),
      shapes_(shapes) {
  limit({.size_factor = size_factor});
  region_stances_ = context_.stances;
}

void OpenShapes::begin(std::uint32_t region, std::size_t given) {
  limit({.region = region, .size_factor = limits_.size_factor});
  region_stances_ = context_.stances;
  given_ = given;
}

void OpenShapes::limit(const StanceLimits& limits) {
  limits_ = limits;
  ++version_;
  tessera::limit(context_, all_stances_, limits);
}

bool OpenShapes::update(const std::vector<ShapeId>& shut_out, double free_px2) {
  std::vector<ShapeId> missing = this->missing();
  // Other shapes do not wait for one that has no place now. With fit = "all" they do: it needs smaller sizes.
  if (!fit_all_) missing = without(missing, shut_out);
  StanceLimits now{.region = limits_.region, .size_factor = limits_.size_factor};
  now.used_up = joined(scoring_.closed_shapes(missing), shut_out);
  if (fit_all_ && !missing.empty()) now.most_scale_px = most_scale_for(missing, free_px2);
  if (now == limits_) return false;
  limit(now);
  return true;
}

float OpenShapes::most_scale_for(const std::vector<ShapeId>& missing, double free_px2) const {
  std::vector<WantedPieces> left;
  for (const ShapeId shape : missing) {
    if (shapes_.drawing(shape) != shape) continue;  // a drawing and its mirror image count once
    const StanceList& stances = region_stances_.list(shape);
    left.push_back({{stances.min_scale_px, stances.max_scale_px}, double(scoring_.missing_uses(shape))});
  }
  return most_scale_px(free_px2, left);
}

bool OpenShapes::allows(const Candidate& candidate) const {
  return context_.stances.list(candidate.shape).count > 0 &&
         candidate.canvas_from_shape.scale() <= limits_.most_scale_px * (1 + kScaleRounding);
}

std::vector<ShapeId> OpenShapes::missing() const {
  if (!scoring_.limits_uses()) return {};
  std::vector<ShapeId> missing;
  for (std::uint32_t i = 0; i < region_stances_.open_shapes(); ++i) {
    const ShapeId shape = region_stances_.open_shape(i);
    if (scoring_.missing_uses(shape) > 0) missing.push_back(shape);
  }
  return missing;
}

Shortage OpenShapes::shortage() const {
  if (!scoring_.limits_uses()) return {};
  Shortage shortage;
  double wanted_px2 = 0;
  double missing_px2 = 0;
  for (std::uint32_t i = 0; i < region_stances_.open_shapes(); ++i) {
    const ShapeId shape = region_stances_.open_shape(i);
    if (shapes_.drawing(shape) != shape) continue;  // a drawing and its mirror image count once
    const StanceList& stances = region_stances_.list(shape);
    const double px2 = double(stances.min_scale_px) * double(stances.max_scale_px);
    wanted_px2 += scoring_.least_uses(shape) * px2;
    missing_px2 += scoring_.missing_uses(shape) * px2;
    shortage.pieces += std::uint64_t(scoring_.missing_uses(shape));
  }
  if (shortage.pieces > 0) shortage.placed = 1 - missing_px2 / wanted_px2;
  return shortage;
}

bool OpenShapes::may_go_on() const {
  StanceLimits by_uses = limits_;
  by_uses.used_up = scoring_.closed_shapes(missing());
  return all_stances_.limited(by_uses).open_shapes() > 0;
}

PoseRange OpenShapes::poses_of(const Placement& p) const {
  for (const Stance& stance : region_stances_.of(region_stances_.list(p.shape))) {
    const PoseRange poses = sized_at(context_, stance, p.canvas_from_shape.translation()).poses;
    if (poses.contains(p.canvas_from_shape) || is_rounded_out_of(poses, p.canvas_from_shape)) return poses;
  }
  const Similarity& pose = p.canvas_from_shape;
  const float scale_px = pose.scale();
  return {scale_px, scale_px, {{pose.a / scale_px, pose.b / scale_px}, {1, 0}}};
}

}  // namespace tessera::master
