// How much of what a canvas' lines enclose is covered by the drawing: little, where the drawing is an outline alone.
#pragma once

#include "core/field/canvas.h"

namespace tessera {

/// A drawing that covers a smaller part of what it encloses than this is taken for an outline. A ring is one where its
/// line is thinner than 1/15 of its diameter; letters and frames cover more.
inline constexpr double kOutlineAlone = 0.25;

/// The area of the canvas as a part of all that its outer edge encloses, above 0 up to 1: nearly 1 without holes (a
/// line between two nodes of the grid counts as closed). Zones that pieces keep out of count as covered.
double covered_part_of_enclosed(const Canvas& canvas);

/// The same of the zones themselves (canvas.keep_out); 1 where there are none.
double zones_part_of_enclosed(const Canvas& canvas);

}  // namespace tessera
