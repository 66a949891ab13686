// The part of an enclosed area that a canvas drawing covers: small where the drawing is only an outline.
#pragma once

#include "core/field/canvas.h"

namespace tessera {

/// A drawing that covers a smaller part of what it encloses is taken for an outline. For a ring this means a line
/// thinner than 1/15 of its diameter; letters and frames cover more.
inline constexpr double kMostCoveredByOutline = 0.25;

/// The area of the canvas divided by the area within its outer edge: above 0 and at most 1, nearly 1 without holes. A
/// line between two nodes of the grid also counts as closed. Keep-out zones count as covered.
double covered_share(const Canvas& canvas);

/// The covered part for the keep-out zones alone (canvas.keep_out); 1 where there are none.
double zones_part_of_enclosed(const Canvas& canvas);

}  // namespace tessera
