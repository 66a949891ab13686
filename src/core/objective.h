// The objective function (paper section 4) and the scale-aware score (design, method 7). Only the master calls it.
#pragma once

#include "core/docking_terms.h"
#include "core/settings.h"

namespace tessera {

/// A candidate's size as the objective sees it.
struct PieceSize {
  float scale_px;
  float perimeter_px;
  float max_scale_px;
};

/// Objective::paper: Z = L / sqrt(w2 sum O_i² + w3 sum G_i²), times (s / s_max)^scale_exponent (w1 cancels in a
/// ranking). Objective::scale_aware: (L / perimeter)^length_exponent / (1 + 5 (w2 O + w3 G) / area) · (s / s_max)^...
float objective(const DockingTerms& terms, const PieceSize& piece, const ObjectiveSettings& settings);

}  // namespace tessera
