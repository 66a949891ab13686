// Exact Euclidean distance transform in O(nodes), after Felzenszwalb and Huttenlocher, "Distance transforms of sampled
// functions" (2012). It is the integer form of Meijster, Roerdink and Hesselink (2000), so no rounding decides
// anything.
#pragma once

#include <cstdint>

#include "core/geometry/grid.h"

namespace tessera {

/// The squared distance, in nodes², of every node to the nearest node of `set` that is not zero; infinity everywhere if
/// the set is empty. Exact up to 2^24 nodes², rounded to nearest beyond. Needs width + height <= 32768.
Grid<float> squared_distance_to(const Grid<std::uint8_t>& set);

}  // namespace tessera
