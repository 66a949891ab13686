#include <cmath>

#include "core/collage/objective.h"
#include "core/settings/tuning.h"

namespace tessera {
/// Positive as soon as anything matches: a poor piece is better than a hole.
float scale_aware_objective(const DockingTerms& t, const PieceSize& piece, const ObjectiveSettings& w) {
  const float area = piece.scale_px * piece.scale_px;
  const float defect = (w.overlap_weight * t.overlap_px2 + w.gap_weight * t.gap_px2) / area;
  return std::pow(t.matched_px / piece.perimeter_px, w.length_exponent) / (1 + kDefectCost * defect);
}

}  // namespace tessera
