#include "master/scoring.h"

#include <algorithm>
#include <cmath>

#include "core/collage/objective.h"
#include "core/tuning.h"

namespace tessera::master {

Scoring::Scoring(const CollageSettings& settings, const StanceTable& stances, const Period& period)
    : pieces_(settings.pieces),
      wishes_(settings.wishes),
      objective_(settings.objective),
      period_(period),
      poses_(stances.library_shapes()) {
  for (const Stance& stance : stances.stances()) weight_.push_back(stance.weight);
  limits_uses_ = pieces_.fit_all || pieces_.uses > 0 || pieces_.least_uses > 0;
  for (const ShapeWish& wish : wishes_.classes) {
    limits_uses_ = limits_uses_ || wish.uses.value_or(0) > 0 || wish.least_uses.value_or(0) > 0;
  }
}

void Scoring::count(const Placement& placement) { poses_[index_of(placement.shape)].push_back(placement.canvas_from_shape); }

void Scoring::forget_placements() {
  for (std::vector<Similarity>& poses : poses_) poses.clear();
}

/// Null where nothing is wished.
const ShapeWish* Scoring::wish_of(ShapeId shape) const {
  if (wishes_.classes.empty()) return nullptr;
  return &wishes_.classes[wishes_.class_of_shape.empty() ? 0 : wishes_.class_of_shape[index_of(shape)]];
}

int Scoring::most_uses(ShapeId shape) const {
  const ShapeWish* wish = wish_of(shape);
  return wish ? wish->uses.value_or(pieces_.uses) : pieces_.uses;
}

int Scoring::least_uses(ShapeId shape) const {
  const ShapeWish* wish = wish_of(shape);
  const int least = wish ? wish->least_uses.value_or(pieces_.least_uses) : pieces_.least_uses;
  return pieces_.fit_all ? std::max(1, least) : least;
}

bool Scoring::is_missing(ShapeId shape) const {
  return poses_[index_of(shape)].size() < std::size_t(least_uses(shape)) && may_use(shape);
}

std::vector<ShapeId> Scoring::closed_shapes(const std::vector<ShapeId>& missing) const {
  std::vector<ShapeId> closed;
  for (std::uint32_t i = 0; i < poses_.size(); ++i) {
    const ShapeId shape{i};
    const bool waits = !missing.empty() && !std::binary_search(missing.begin(), missing.end(), shape);
    if (waits || !may_use(shape)) closed.push_back(shape);
  }
  return closed;
}

bool Scoring::may_use(ShapeId shape) const {
  const int most = most_uses(shape);
  return most == 0 || poses_[index_of(shape)].size() < std::size_t(most);
}

bool Scoring::acceptable(const Candidate& candidate) const {
  const float scale = candidate.canvas_from_shape.scale();
  return candidate.terms.overlap_px2 <= kMaxOverlap * scale * scale &&
         candidate.terms.matched_px >= kLeastMatched * candidate.perimeter * scale;
}

/// With padding the areas are those of grown pieces, and the outlines themselves are apart.
bool Scoring::overlaps_little(const Candidate& candidate, const ExactAreas& areas) const {
  const float scale = candidate.canvas_from_shape.scale();
  return pieces_.padding_px > 0 || areas.overlap_px2 <= kMaxOverlap * scale * scale;
}

float Scoring::score(const Candidate& candidate) const {
  const float scale = candidate.canvas_from_shape.scale();
  const PieceSize size{scale, candidate.perimeter * scale, pieces_.max_scale_px};
  return objective(candidate.terms, size, objective_) * weight_[candidate.stance];
}

/// Repetition costs something, or one shape that fits everywhere fills the canvas.
float Scoring::preference(const Candidate& candidate) const {
  const std::vector<Similarity>& placed = poses_[index_of(candidate.shape)];
  if (placed.empty()) return 1;
  float factor = std::pow(1.f + float(placed.size()), -objective_.repetition_exponent);
  const float radius = candidate.radius + kNearTwinReach;
  for (const Similarity& pose : placed) {
    const float near = radius * (pose.scale() + candidate.canvas_from_shape.scale());
    const Vec2 centre = candidate.canvas_from_shape.translation();
    const Vec2 apart = period_.nearest(pose.translation(), centre) - centre;
    if (dot(apart, apart) < near * near) factor *= objective_.near_twin_factor;
  }
  return factor;
}

}  // namespace tessera::master
