// A shape of which fewer pieces stand in a finished collage than the job wants at least.
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
  int wanted = 0;    // at least
  int standing = 0;  // fewer

  friend bool operator==(const MissingShape&, const MissingShape&) = default;
};

/// How many pieces are missing.
inline std::uint64_t pieces_of(const std::vector<MissingShape>& missing) {
  std::uint64_t pieces = 0;
  for (const MissingShape& shape : missing) pieces += std::uint64_t(shape.wanted - shape.standing);
  return pieces;
}

/// "ant (3 of 5), bee (0 of 5) and 4 more shapes": the first `most` by name, on one line of a terminal.
std::string missing_text(const std::vector<MissingShape>& missing, std::size_t most);

}  // namespace tessera
