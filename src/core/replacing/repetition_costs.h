// The costs of repeated drawings in a job (RepetitionCosts of replacement.h).
#pragma once

#include <cstddef>

#include "core/matching/stances.h"
#include "core/replacing/replacement.h"
#include "core/settings/settings.h"
#include "core/shape/shape_source.h"

namespace tessera {

/// The number of different drawings that may stand. Mirror images and other colours of a drawing count as the same
/// drawing.
std::size_t count_drawings(const StanceTable& stances, const ShapeSource& shapes);

/// The costs on `area_px2` of canvas with `drawings` different drawings. An even share is the area that each drawing
/// would cover if all covered alike, but at least a piece of the middle size. Copies affect each other up to half the
/// distance that they would have if all drawings took turns. So the reach is shorter with few drawings, whose copies
/// cannot avoid each other.
RepetitionCosts repetition_costs(const CollageSettings& settings, std::size_t drawings, double area_px2);

}  // namespace tessera
