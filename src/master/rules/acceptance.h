// Whether a candidate may stand as a piece, judged by its terms alone: no overlap may show, and it must touch something.
#pragma once

#include "core/collage/exact_terms.h"
#include "core/collage/pool.h"

namespace tessera::master {

/// Whether the overlap at the contour samples is too small to show.
bool overlaps_little(const Candidate& candidate);
/// Whether the exact areas agree that no overlap shows. Contour samples alone see no overlap where lines lie on lines.
bool overlaps_little(const Candidate& candidate, const ExactAreas& areas, float padding_px);
/// Whether enough of the candidate's boundary lies on the target curve.
bool touches(const Candidate& candidate);
/// Whether the candidate overlaps little and touches something.
bool acceptable(const Candidate& candidate);

}  // namespace tessera::master
