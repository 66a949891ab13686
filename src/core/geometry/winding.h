// Detects closed curves that cross themselves or each other.
#pragma once

#include "core/geometry/polygon.h"

namespace tessera {

/// The area with a winding number other than 0 and 1: the outline runs around it backwards or several times. It is 0 if
/// outer curves have positive and holes negative area, and no curve crosses another or itself. Measured on horizontal
/// lines, two units apart, but at least 16 and at most 128 of them.
double twisted_area(const Outline& outline);

}  // namespace tessera
