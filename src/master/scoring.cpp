#include "master/scoring.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/collage/objective.h"
#include "core/tuning.h"

namespace tessera::master {

Scoring::Scoring(const CollageSettings& settings, std::uint32_t library_shapes, std::vector<ShapeId> silhouettes)
    : pieces_(settings.pieces),
      objective_(settings.objective),
      silhouettes_(std::move(silhouettes)),
      placed_(library_shapes) {
  for (std::uint32_t shape = std::uint32_t(silhouettes_.size()); shape < library_shapes; ++shape)
    silhouettes_.push_back(ShapeId(shape));
}

void Scoring::count(const Placement& placement) {
  placed_[silhouette(placement.shape)].push_back({placement.shape, placement.canvas_from_shape});
}

void Scoring::forget_placements() {
  for (std::vector<Placed>& placed : placed_) placed.clear();
}

bool Scoring::may_use(ShapeId shape) const {
  return pieces_.uses == 0 || placed_[silhouette(shape)].size() < std::size_t(pieces_.uses);
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
  return objective(candidate.terms, size, objective_);
}

/// Repetition costs something, or one shape that fits everywhere fills the canvas.
float Scoring::preference(const Candidate& candidate) const {
  const std::vector<Placed>& placed = placed_[silhouette(candidate.shape)];
  if (placed.empty()) return 1;
  const auto same_colours = std::count_if(placed.begin(), placed.end(),
                                          [&](const Placed& other) { return other.shape == candidate.shape; });
  const float uses = float(same_colours) + kUseInOtherColours * float(std::ptrdiff_t(placed.size()) - same_colours);
  float factor = std::pow(1.f + uses, -objective_.repetition_exponent);
  const float radius = candidate.radius + kNearTwinReach;
  for (const Placed& other : placed) {
    const Similarity& pose = other.canvas_from_shape;
    const float near = radius * (pose.scale() + candidate.canvas_from_shape.scale());
    const Vec2 apart = pose.translation() - candidate.canvas_from_shape.translation();
    if (dot(apart, apart) < near * near) factor *= objective_.near_twin_factor;
  }
  return factor;
}

}  // namespace tessera::master
