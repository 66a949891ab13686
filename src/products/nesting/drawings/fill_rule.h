// Finds the visible contours of a filled path.
#pragma once

#include <vector>

#include "products/nesting/layout/nest_polygon.h"

namespace tessera {

/// Whether the fill ends at each contour of one path. By the even-odd rule it always does. By the nonzero rule a contour
/// inside another one with the same direction has fill on both sides. Contours that cross are not examined.
std::vector<bool> ends_fill(const std::vector<NestRing>& contours, bool even_odd);

}  // namespace tessera
