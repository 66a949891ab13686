#include "core/collage/objective.h"

#include <cmath>

#include "core/settings/tuning.h"

namespace tessera {

const std::array<ObjectiveKind, 2>& objective_kinds() {
  static const std::array<ObjectiveKind, 2> kinds = {{
      {"scale_aware", scale_aware_objective},
      {"paper", paper_objective},
  }};
  return kinds;
}

float balance_of(const ObjectiveSettings& settings) {
  return settings.kind == Objective::scale_aware ? settings.balance : 0;
}

ObjectiveSettings balanced(ObjectiveSettings settings) {
  const float balance = balance_of(settings);
  settings.length_exponent += kBalanceOfLength * balance;
  settings.scale_exponent += kBalanceOfScale * balance;
  settings.repetition_exponent *= 1 + kBalanceOfRepetition * balance;
  settings.balance = 0;
  return settings;
}

float objective(const DockingTerms& terms, const PieceSize& piece, const ObjectiveSettings& settings) {
  const ObjectiveSettings s = balanced(settings);
  const float fit = objective_kinds()[std::size_t(s.kind)].function(terms, piece, s);
  return fit * std::pow(piece.scale_px / piece.max_scale_px, s.scale_exponent);
}

}  // namespace tessera
