// The objective function (paper section 4) and its alternatives. Only the master calls it.
//
// To add one: a file objective_NAME.cpp, a word in enum Objective (settings.h) and a row of the table in objective.cpp.
// The job key objective.kind uses that name.
#pragma once

#include <array>

#include "core/matching/docking_terms.h"
#include "core/settings/settings.h"

namespace tessera {

/// A candidate's size, as the objective needs it.
struct PieceSize {
  float scale_px;
  float perimeter_px;
  float max_scale_px;
};

/// A function whose value is at least 0; larger is better.
using ObjectiveFunction = float (*)(const DockingTerms&, const PieceSize&, const ObjectiveSettings&);

/// Z = L / sqrt(w2 sum O_i² + w3 sum G_i²) of the paper; w1 cancels in a ranking. kLeastDefect of the piece's area is
/// added to the divisor, so that Z is finite for a perfect fit.
float paper_objective(const DockingTerms& terms, const PieceSize& piece, const ObjectiveSettings& settings);

/// (L / perimeter)^length_exponent / (1 + kDefectCost (w2 O + w3 G) / area).
float scale_aware_objective(const DockingTerms& terms, const PieceSize& piece, const ObjectiveSettings& settings);

struct ObjectiveKind {
  const char* name;  // as in a job
  ObjectiveFunction function;
};

/// The kinds stand in the order of enum class Objective.
const std::array<ObjectiveKind, 2>& objective_kinds();

/// The balance of sizes; 0 for the paper's Z, which has none.
float balance_of(const ObjectiveSettings& settings);

/// Moves `balance` into the exponents and sets it to 0. The more even the sizes should be, the more the touching part
/// of a piece's boundary counts.
ObjectiveSettings balanced(ObjectiveSettings settings);

/// The function of the kind that the settings name, balanced, times (s / s_max)^scale_exponent.
float objective(const DockingTerms& terms, const PieceSize& piece, const ObjectiveSettings& settings);

}  // namespace tessera
