// A shape of which a finished collage has fewer pieces than the job wants at least.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/shape/shape_id.h"

namespace tessera {

struct MissingShape {
  ShapeId id{};      // in the library
  std::string name;  // as the library has it
  int wanted = 0;    // the least number
  int standing = 0;  // the number of its pieces, which is smaller

  friend bool operator==(const MissingShape&, const MissingShape&) = default;
};

/// The number of missing pieces.
inline std::uint64_t pieces_of(const std::vector<MissingShape>& missing) {
  std::uint64_t pieces = 0;
  for (const MissingShape& shape : missing) pieces += std::uint64_t(shape.wanted - shape.standing);
  return pieces;
}

/// "ant (3 of 5), bee (0 of 5) and 4 more shapes": names the first `most` shapes on one line of a terminal.
std::string missing_text(const std::vector<MissingShape>& missing, std::size_t most);

}  // namespace tessera
