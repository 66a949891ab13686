// The objective function (paper section 4) and what may stand in its place. Only the master calls it.
//
// A new one is a file of its own (objective_NAME.cpp), a word in enum Objective (settings.h) and a row of the table in
// objective.cpp; the job key objective.kind knows it by its name.
#pragma once

#include <array>

#include "core/matching/docking_terms.h"
#include "core/settings/settings.h"

namespace tessera {

/// A candidate's size as the objective sees it.
struct PieceSize {
  float scale_px;
  float perimeter_px;
  float max_scale_px;
};

/// The larger its value, the better the candidate; it is at least 0.
using ObjectiveFunction = float (*)(const DockingTerms&, const PieceSize&, const ObjectiveSettings&);

/// Z = L / sqrt(w2 sum O_i² + w3 sum G_i²) of the paper; w1 cancels in a ranking. The divisor has kLeastDefect of the
/// piece's area added, so that Z is finite for a perfect fit.
float paper_objective(const DockingTerms& terms, const PieceSize& piece, const ObjectiveSettings& settings);

/// (L / perimeter)^length_exponent / (1 + kDefectCost (w2 O + w3 G) / area).
float scale_aware_objective(const DockingTerms& terms, const PieceSize& piece, const ObjectiveSettings& settings);

struct ObjectiveKind {
  const char* name;  // in a job
  ObjectiveFunction function;
};

/// The kinds stand in the order of enum class Objective.
const std::array<ObjectiveKind, 2>& objective_kinds();

/// The paper's Z knows none: 0.
float balance_of(const ObjectiveSettings& settings);

/// The settings without `balance`, which is in the exponents instead: the more even sizes are to be, the more counts
/// how much of a piece's boundary touches.
ObjectiveSettings balanced(ObjectiveSettings settings);

/// The function of the kind that the settings name, balanced, times (s / s_max)^scale_exponent.
float objective(const DockingTerms& terms, const PieceSize& piece, const ObjectiveSettings& settings);

}  // namespace tessera
