// Difference between a piece's colours and the colours of the picture that it covers. kernels/colour.cl computes the
// same for many pieces at once, bit for bit.
#pragma once

#include <optional>

#include "core/colour/colour_grid.h"
#include "core/colour/colour_target.h"
#include "core/geometry/similarity.h"

namespace tessera {

/// CIEDE2000 between the piece's mean colour and the mean colour of the place it covers, by one look-up. 0 where the
/// target wishes nothing.
float mean_colour_difference(const ColourModel& piece, const Similarity& canvas_from_shape, const ColourTarget& target);

/// The root of the mean square of the cells' differences (CIEDE2000). One cell of a quite different colour costs more
/// than many cells that are a little off. Detail of a drawing over a smooth part of the picture costs, too. The
/// difference is 0 where the target wishes nothing.
float colour_difference(const ColourModel& piece, const Similarity& canvas_from_shape, const ColourTarget& target);

/// The mean colour of the place that the piece covers; empty where the target wishes nothing there.
std::optional<Lab> covered_colour(const ColourModel& piece, const Similarity& canvas_from_shape,
                                  const ColourTarget& target);

/// Factor for a key or score at this colour difference: 1 at no difference, falling towards 0.
float colour_worth(float difference, float weight);

}  // namespace tessera
