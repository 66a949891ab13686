// A shape of a library in a pose on a query.
#pragma once

#include <cstdint>

#include "core/geometry/similarity.h"

namespace tessera {

struct PosedShape {
  std::uint32_t shape = 0;  // of KnownShapes
  Similarity query_from_shape;
  float followed = 0;  // how good the pose is, by whatever measure was last taken
};

}  // namespace tessera
