#include "core/collage/objective.h"

#include <cmath>

namespace tessera {

const std::array<ObjectiveKind, 2>& objective_kinds() {
  static const std::array<ObjectiveKind, 2> kinds = {{
      {"scale_aware", scale_aware_objective},
      {"paper", paper_objective},
  }};
  return kinds;
}

float objective(const DockingTerms& terms, const PieceSize& piece, const ObjectiveSettings& settings) {
  const float fit = objective_kinds()[std::size_t(settings.kind)].function(terms, piece, settings);
  return fit * std::pow(piece.scale_px / piece.max_scale_px, settings.scale_exponent);
}

}  // namespace tessera
