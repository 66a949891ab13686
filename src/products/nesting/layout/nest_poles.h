// Discs inside a shape, from which the overlap of two shapes is estimated.
#pragma once

#include <vector>

#include "products/nesting/layout/nest_polygon.h"

namespace tessera {

struct NestPole {
  NestPoint centre;
  double radius = 0;
};

/// Discs inside the ring that do not overlap, the largest first, until they cover nine tenths of it or there are `most` of
/// them. There is at least one, whose centre is inside.
std::vector<NestPole> poles_of(const NestRing& ring, int most);

}  // namespace tessera
