#include "core/replacing/hole_candidates.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/portable_math.h"
#include "core/matching/match_round.h"
#include "core/relax/relaxation_step.h"

namespace tessera {
namespace {

constexpr int kDockings = 1500;
constexpr std::size_t kRefinedInHole = 20;
constexpr std::size_t kTried = 4;
constexpr std::size_t kDockingParts = 4;  // parts of the dockings that are scored in parallel
constexpr int kRefineSteps = 14;
constexpr float kMostStep_px = 4;
constexpr float kRefineStiffness_px = 30;  // stiffness is 1 at a scale of this many px: larger pieces may lie deeper
constexpr float kHoleStepDamping = 0.02f;
constexpr float kMostDepth = 0.3f;       // cost of a px of depth per px of boundary, px², times the softness
constexpr float kRoomSpread = 0.43f;     // octaves: range of drawn scales around the size that there is room for
constexpr float kSameInHole = 0.15f;     // of the scale
constexpr float kLargerThanFree = 1.1f;  // candidates may be larger than the free area, as neighbours make room

const BoundarySamples& boundary_of(const HoleShape& shape) { return shape.contact.samples.back(); }

/// The score of a pose; stops as soon as it falls below `least`.
float score(const Hole& hole, const CandidateShape& guest, const Similarity& pose, float softness, float least) {
  const float scale = pose.scale();
  const float worth = guest.worth * scale * scale;
  const float inside = softness * scale * scale / float(guest.shape->interior.size());
  const float per_cell = 0.5f / hole.cell_px();
  float cost = 0;
  for (const Vec2 p : guest.shape->interior) {
    const float covered = 0.5f - hole.at(pose.apply(p)).value * per_cell;
    if (!(covered > 0)) continue;
    cost += inside * std::min(covered, 1.f);
    if (worth - cost < least) return worth - cost;
  }
  const float along = kMostDepth * softness * scale;
  for (const BoundarySample& sample : boundary_of(*guest.shape).samples) {
    const float distance = hole.at(pose.apply(sample.position)).value;
    if (!(distance < 0)) continue;
    cost -= along * sample.length * distance;
    if (worth - cost < least) return worth - cost;
  }
  return worth - cost;
}

/// The pose after moving, turning and growing in the hole.
Similarity refined(const Hole& hole, const CandidateShape& guest, Similarity pose) {
  const ContactShape& shape = guest.shape->contact;
  for (int k = 0; k < kRefineSteps; ++k) {
    const float scale = pose.scale();
    const float stiffness = kRefineStiffness_px / scale;
    RelaxationStep step(pose);
    const auto feel = [&](Vec2 p, float length) {
      const Vec2 at = pose.apply(p);
      const FieldSample here = hole.at(at);
      if (here.value < 0) step.add_own({at, here.value, here.gradient, length * scale}, -here.value, stiffness);
    };
    for (const BoundarySample& sample : boundary_of(*guest.shape).samples) feel(sample.position, sample.length);
    const float inner = 0.5f * shape.perimeter / float(guest.shape->interior.size());
    for (const Vec2 p : guest.shape->interior) feel(p, inner);
    step.add_growth();
    step.add_damping(kHoleStepDamping * stiffness * shape.perimeter * scale);
    const PieceMovement movement = step.solved(pose, guest.poses);
    const float wanted_px = movement.largest();
    pose = moved(pose, movement, wanted_px > kMostStep_px ? kMostStep_px / wanted_px : 1.f, guest.poses);
  }
  return pose;
}

bool scores_better(const HoleCandidate& a, const HoleCandidate& b) { return a.score_px2 > b.score_px2; }

/// The pose that puts the dock point on the rim, with the shape's inside in the hole.
Similarity docked(const DockPoint& dock, const RimPoint& rim, float scale_px, const PoseRange& poses) {
  // The rotation from the dock's `inward` to the rim's `inward`.
  Similarity pose{scale_px * dot(dock.inward, rim.inward), scale_px * cross(dock.inward, rim.inward), 0, 0};
  poses.pull_in(pose);
  const Vec2 at = rim.at - pose.apply(dock.at);
  return {pose.a, pose.b, at.x, at.y};
}

float drawn_scale_px(const CandidateShape& guest, const DockPoint& dock, const RimPoint& rim, float most_px,
                     Draws& draws) {
  const float spread = kRoomSpread * (draws.unit() - 0.5f);
  const float wanted = rim.room_px / dock.thickness * portable_exp2(spread);
  return std::clamp(wanted, guest.poses.min_scale_px,
                    std::max(guest.poses.min_scale_px, std::min(most_px, guest.poses.max_scale_px)));
}

/// A dock point whose docking has an allowed rotation, or nearly, if some draws find one.
const DockPoint& drawn_dock(const CandidateShape& guest, const RimPoint& rim, Draws& draws) {
  constexpr int kMostDraws = 16;
  constexpr float kNearly_rad = 0.3f;
  const std::vector<DockPoint>& docks = guest.shape->docks;
  const DockPoint* dock = &docks[draws.below(docks.size())];
  if (guest.poses.rotations.all()) return *dock;
  for (int k = 1; k < kMostDraws; ++k) {
    const Vec2 turn{dot(dock->inward, rim.inward), cross(dock->inward, rim.inward)};
    if (guest.poses.rotations.contains(turn, 1, kNearly_rad)) break;
    dock = &docks[draws.below(docks.size())];
  }
  return *dock;
}

/// Random dockings, not yet scored.
std::vector<HoleCandidate> drawn(const Hole& hole, float reach_px, const std::vector<CandidateShape>& guests,
                                 Draws& draws) {
  std::vector<HoleCandidate> all;
  const std::vector<RimPoint> rim = hole.rim(reach_px);
  if (rim.empty() || guests.empty()) return all;
  const float most_px = kLargerThanFree * std::sqrt(hole.free_px2(reach_px));
  for (int k = 0; k < kDockings; ++k) {
    const std::size_t g = draws.below(guests.size());
    const CandidateShape& guest = guests[g];
    const RimPoint& at = rim[draws.below(rim.size())];
    if (draws.unit() >= guest.weight || guest.poses.min_scale_px > most_px || guest.shape->docks.empty()) continue;
    const DockPoint& dock = drawn_dock(guest, at, draws);
    all.push_back({g, docked(dock, at, drawn_scale_px(guest, dock, at, most_px, draws), guest.poses)});
  }
  return all;
}

void keep_best(const HoleCandidate& candidate, std::vector<HoleCandidate>& best) {
  best.insert(std::upper_bound(best.begin(), best.end(), candidate, scores_better), candidate);
  if (best.size() > kRefinedInHole) best.pop_back();
}

/// The candidates with the best scores; among equal ones the first.
std::vector<HoleCandidate> best_of(std::span<const HoleCandidate> drawn, const Hole& hole,
                                   const std::vector<CandidateShape>& guests, float softness) {
  std::vector<HoleCandidate> best;
  for (HoleCandidate candidate : drawn) {
    const float least = best.size() < kRefinedInHole ? 0.f : best.back().score_px2;
    candidate.score_px2 = score(hole, guests[candidate.incoming], candidate.canvas_from_shape, softness, least);
    if (candidate.score_px2 > least) keep_best(candidate, best);
  }
  return best;
}

/// best_of(), divided among threads if one is idle. Otherwise one thread is better: it knows the best scores up to now
/// and skips more candidates.
std::vector<HoleCandidate> shared_best_of(const std::vector<HoleCandidate>& drawn, const Hole& hole,
                                          const std::vector<CandidateShape>& guests, float softness, TaskPool& pool) {
  if (!pool.has_idle_thread()) return best_of(drawn, hole, guests, softness);
  std::vector<std::vector<HoleCandidate>> parts(kDockingParts);
  pool.run(kDockingParts, [&](std::size_t k) {
    const std::size_t begin = drawn.size() * k / kDockingParts;
    const std::size_t end = drawn.size() * (k + 1) / kDockingParts;
    parts[k] = best_of(std::span(drawn).subspan(begin, end - begin), hole, guests, softness);
  });
  std::vector<HoleCandidate> best;
  for (const std::vector<HoleCandidate>& part : parts) {
    for (const HoleCandidate& candidate : part) keep_best(candidate, best);
  }
  return best;
}

}  // namespace

std::vector<HoleCandidate> best_candidates(const Hole& hole, float reach_px, const std::vector<CandidateShape>& guests,
                                           float softness, Draws& draws, TaskPool& pool) {
  const std::vector<HoleCandidate> all = drawn(hole, reach_px, guests, draws);
  std::vector<HoleCandidate> candidates = shared_best_of(all, hole, guests, softness, pool);
  pool.run(candidates.size(), [&](std::size_t i) {
    HoleCandidate& c = candidates[i];
    c.canvas_from_shape = refined(hole, guests[c.incoming], c.canvas_from_shape);
    c.score_px2 = score(hole, guests[c.incoming], c.canvas_from_shape, softness, 0);
  });
  std::stable_sort(candidates.begin(), candidates.end(), scores_better);
  std::vector<HoleCandidate> distinct;
  for (const HoleCandidate& c : candidates) {
    if (c.score_px2 <= 0 || distinct.size() == kTried) break;
    const bool known = std::any_of(distinct.begin(), distinct.end(), [&](const HoleCandidate& d) {
      return d.incoming == c.incoming && near_copy(d.canvas_from_shape, c.canvas_from_shape, kSameInHole);
    });
    if (!known) distinct.push_back(c);
  }
  return distinct;
}

}  // namespace tessera
