// Discs that stand for the inside of a shape: how deep two shapes lie in each other is estimated by them.
#pragma once

#include <vector>

#include "products/nesting/layout/nest_polygon.h"

namespace tessera {

struct NestPole {
  NestPoint centre;
  double radius = 0;
};

/// Discs inside the ring that do not overlap, the largest first, until they cover nine tenths of it or are
/// `most` many. At least one, whose centre is inside.
std::vector<NestPole> poles_of(const NestRing& ring, int most);

}  // namespace tessera
