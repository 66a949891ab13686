// Whether closed curves bound what the even-odd rule fills, or cross themselves and each other.
#pragma once

#include "core/geometry/polygon.h"

namespace tessera {

/// The area round which the outline runs neither once nor not at all: backwards, or several times. 0 where outer curves
/// have positive and holes negative area, and none crosses another or itself. Measured on lines across, two units
/// apart, but 16 to 128 of them.
double twisted_area(const Outline& outline);

}  // namespace tessera
