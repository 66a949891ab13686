#include "master/scoring.h"

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
}

void Scoring::count(const Placement& placement) { poses_[index_of(placement.shape)].push_back(placement.canvas_from_shape); }

void Scoring::forget_placements() {
  for (std::vector<Similarity>& poses : poses_) poses.clear();
}

int Scoring::most_uses(ShapeId shape) const {
  if (wishes_.classes.empty()) return pieces_.uses;
  const std::size_t wished = wishes_.class_of_shape.empty() ? 0 : wishes_.class_of_shape[index_of(shape)];
  return wishes_.classes[wished].uses.value_or(pieces_.uses);
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
