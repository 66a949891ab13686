// The pieces that a collage lacks although they must find a place.
#pragma once

#include <cstdint>

namespace tessera::master {

struct Shortage {
  std::uint64_t pieces = 0;
  double placed = 1;  // part of the wanted pieces that stands, by their areas at the middle of their sizes
};

}  // namespace tessera::master
