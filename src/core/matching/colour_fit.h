// How far a piece's colours are from those that it covers. kernels/colour.cl does the same for many at once, bit for
// bit.
#pragma once

#include <optional>

#include "core/colour/colour_grid.h"
#include "core/colour/colour_target.h"
#include "core/geometry/similarity.h"

namespace tessera {

/// CIEDE2000 between the piece's mean and that of the place, by one look-up. 0 where the target wishes nothing.
float mean_colour_difference(const ColourModel& piece, const Similarity& canvas_from_shape, const ColourTarget& target);

/// The root of the mean square of the cells' differences: a part of quite another colour is seen more than many that are
/// a little off, and so is what a drawing shows within a smooth part of the picture. 0 where the target wishes nothing.
float colour_difference(const ColourModel& piece, const Similarity& canvas_from_shape, const ColourTarget& target);

/// The mean colour of what the piece covers; nothing where the target wishes nothing there.
std::optional<Lab> covered_colour(const ColourModel& piece, const Similarity& canvas_from_shape,
                                  const ColourTarget& target);

/// What is left of a key or score at that difference: 1 to 0.
float colour_worth(float difference, float weight);

}  // namespace tessera
