#include "master/rules/acceptance.h"

#include "core/settings/tuning.h"

namespace tessera::master {

bool overlaps_little(const Candidate& candidate) {
  const float scale_px = candidate.canvas_from_shape.scale();
  return candidate.terms.overlap_px2 <= kMaxOverlap * scale_px * scale_px;
}

/// With padding, `areas` are those of grown pieces, and the outlines themselves are apart.
bool overlaps_little(const Candidate& candidate, const ExactAreas& areas, float padding_px) {
  const float scale_px = candidate.canvas_from_shape.scale();
  return padding_px > 0 || areas.overlap_px2 <= kMaxOverlap * scale_px * scale_px;
}

bool touches(const Candidate& candidate) {
  const float scale_px = candidate.canvas_from_shape.scale();
  return candidate.terms.matched_px >= kLeastMatched * candidate.perimeter * scale_px;
}

bool acceptable(const Candidate& candidate) { return overlaps_little(candidate) && touches(candidate); }

}  // namespace tessera::master
