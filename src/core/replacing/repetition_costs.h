// How much the repetition of drawings costs in a job (RepetitionCosts of replacement.h).
#pragma once

#include <cstddef>

#include "core/matching/stances.h"
#include "core/replacing/replacement.h"
#include "core/settings/settings.h"
#include "core/shape/shape_source.h"

namespace tessera {

/// How many different drawings may stand. Mirror images and other colours of a drawing count as the same drawing.
std::size_t count_drawings(const StanceTable& stances, const ShapeSource& shapes);

/// The costs on `area_px2` of canvas with so many `drawings`. An even share is what each drawing would cover if all
/// covered alike, but never less than a piece of the middle size. Copies reach each other half as far as they would lie
/// apart if all drawings took turns: so equally many copies of few drawings lie near each other, wherever they lie.
RepetitionCosts repetition_costs(const CollageSettings& settings, std::size_t drawings, double area_px2);

}  // namespace tessera
