// Which contours of a filled path are to be seen.
#pragma once

#include <vector>

#include "products/nesting/layout/nest_polygon.h"

namespace tessera {

/// For each contour of one path whether the fill ends there. By the even-odd rule it does everywhere. By the nonzero rule
/// a contour inside another that runs the same way has fill on both sides. Contours that cross are not looked into.
std::vector<bool> ends_fill(const std::vector<NestRing>& contours, bool even_odd);

}  // namespace tessera
