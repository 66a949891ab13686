// Checks whether the parts of a shape fit each other. A library file may come from anywhere: a field that does not fit
// its outline would let pieces overlap unnoticed.
#pragma once

#include <string>

#include "core/shape/shape.h"

namespace tessera {

/// Checks outline, perimeter, radius and field. The area must be 1, and the lengths must fit the outline. The field
/// must have the right sign at every node, change no faster than a distance can, and be zero along the outline. It must
/// be exact at one node of every 8 x 8; the shape decides which one. Takes half a millisecond. Returns an empty text if
/// all fits, otherwise a text that says what does not.
std::string shape_contradiction(const Shape& shape);

}  // namespace tessera
