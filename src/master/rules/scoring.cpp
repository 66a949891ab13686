#include "master/rules/scoring.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/collage/objective.h"
#include "core/matching/colour_fit.h"
#include "core/settings/tuning.h"

namespace tessera::master {
namespace {

/// Completes the list: each shape that is not listed stands for itself.
std::vector<ShapeId> filled_up(std::vector<ShapeId> listed, std::uint32_t shapes) {
  for (std::uint32_t shape = std::uint32_t(listed.size()); shape < shapes; ++shape) listed.push_back(ShapeId(shape));
  return listed;
}

}  // namespace

Scoring::Scoring(const CollageSettings& settings, const StanceTable& stances, std::vector<ShapeId> silhouettes,
                 const Period& period, std::vector<ShapeId> drawings)
    : pieces_(settings.pieces),
      uses_(settings.pieces, settings.wishes),
      objective_(balanced(settings.objective)),
      colour_(settings.colour),
      neighbours_(settings.colour, period),
      period_(period),
      silhouettes_(filled_up(std::move(silhouettes), stances.library_shapes())),
      drawings_(filled_up(std::move(drawings), stances.library_shapes())),
      copies_(stances.library_shapes()),
      uses_of_drawing_(stances.library_shapes()) {
  for (const Stance& stance : stances.stances()) weight_.push_back(stance.weight);
}

void Scoring::count(const Placement& placement) {
  const Similarity& pose = placement.canvas_from_shape;
  copies_[silhouette(placement.shape)].push_back({pose.translation(), pose.scale()});
  ++uses_of_drawing_[index_of(drawing(placement.shape))];
  neighbours_.add(placement);
}

void Scoring::forget_placements() {
  for (std::vector<Copy>& copies : copies_) copies.clear();
  std::fill(uses_of_drawing_.begin(), uses_of_drawing_.end(), 0);
  neighbours_.forget_placements();
}

int Scoring::missing_uses(ShapeId shape) const { return std::max(0, uses_.least(shape) - uses_of(shape)); }

std::vector<ShapeId> Scoring::closed_shapes(const std::vector<ShapeId>& missing) const {
  std::vector<ShapeId> closed;
  for (std::uint32_t i = 0; i < drawings_.size(); ++i) {
    const ShapeId shape{i};
    const bool waits = !missing.empty() && !std::binary_search(missing.begin(), missing.end(), shape);
    if (waits || !may_use(shape)) closed.push_back(shape);
  }
  return closed;
}

bool Scoring::may_use(ShapeId shape) const {
  const int most = uses_.most(shape);
  return most == 0 || uses_of(shape) < most;
}

float Scoring::score(const Candidate& candidate) const {
  const float scale = candidate.canvas_from_shape.scale();
  const PieceSize size{scale, candidate.perimeter * scale, pieces_.max_scale_px};
  const float score = objective(candidate.terms, size, objective_) * weight_[candidate.stance];
  return colour_ ? score * colour_worth(candidate.terms.colour_difference, colour_.weight) : score;
}

float Scoring::preference(const Candidate& candidate) const {
  return repetition_factor(candidate) * neighbours_.worth(candidate.shape, candidate.canvas_from_shape);
}

/// The cost of repetition. Without it one shape that fits everywhere would fill the canvas.
float Scoring::repetition_factor(const Candidate& candidate) const {
  const std::vector<Copy>& copies = copies_[silhouette(candidate.shape)];
  if (copies.empty()) return 1;
  const int same_colours = uses_of(candidate.shape);
  const float uses = float(same_colours) + kUseInOtherColours * float(int(copies.size()) - same_colours);
  float factor = std::pow(1.f + uses, -objective_.repetition_exponent);
  const float radius = candidate.radius + kNearTwinReach;
  const float scale_px = candidate.canvas_from_shape.scale();
  const Vec2 centre_px = candidate.canvas_from_shape.translation();
  for (const Copy& copy : copies) {
    const float near = radius * (copy.scale_px + scale_px);
    const Vec2 apart = period_.nearest(copy.centre_px, centre_px) - centre_px;
    if (dot(apart, apart) < near * near) factor *= objective_.near_twin_factor;
  }
  return factor;
}

}  // namespace tessera::master
