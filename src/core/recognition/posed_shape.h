// A shape of a library in a pose on a query.
#pragma once

#include <cstdint>

#include "core/geometry/similarity.h"

namespace tessera {

struct PosedShape {
  std::uint32_t shape = 0;  // index in KnownShapes
  Similarity query_from_shape;
  float followed = 0;  // quality of the pose, by the measure that was taken last
};

}  // namespace tessera
