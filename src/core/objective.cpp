#include "core/objective.h"

#include <cmath>

namespace tessera {
namespace {

/// Keeps the paper's Z finite for a perfect fit, px² per px² of the piece.
constexpr float kLeastDefect = 0.0025f;

/// A piece that spoils a fifth of its area counts half. Never nothing: a poor piece is better than a hole.
constexpr float kDefectCost = 5;

float paper_score(const DockingTerms& t, const PieceSize& piece, const ObjectiveSettings& w) {
  const float area = piece.scale_px * piece.scale_px;
  const float defect =
      std::sqrt(w.overlap_weight * t.overlap_px4 + w.gap_weight * t.gap_px4) + kLeastDefect * area;
  return t.matched_px / defect;
}

float scale_aware_score(const DockingTerms& t, const PieceSize& piece, const ObjectiveSettings& w) {
  const float area = piece.scale_px * piece.scale_px;
  const float defect = (w.overlap_weight * t.overlap_px2 + w.gap_weight * t.gap_px2) / area;
  return std::pow(t.matched_px / piece.perimeter_px, w.length_exponent) / (1 + kDefectCost * defect);
}

}  // namespace

float objective(const DockingTerms& terms, const PieceSize& piece, const ObjectiveSettings& settings) {
  const float fit = settings.kind == Objective::paper ? paper_score(terms, piece, settings)
                                                      : scale_aware_score(terms, piece, settings);
  return fit * std::pow(piece.scale_px / piece.max_scale_px, settings.scale_exponent);
}

}  // namespace tessera
