#include <cmath>

#include "core/collage/objective.h"
#include "core/settings/tuning.h"

namespace tessera {
float paper_objective(const DockingTerms& t, const PieceSize& piece, const ObjectiveSettings& w) {
  const float area = piece.scale_px * piece.scale_px;
  const float defect = std::sqrt(w.overlap_weight * t.overlap_px4 + w.gap_weight * t.gap_px4) + kLeastDefect * area;
  return t.matched_px / defect;
}

}  // namespace tessera
