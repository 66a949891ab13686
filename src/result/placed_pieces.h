// pieces.geojson of a result read back, without its polygons.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/collage/placement.h"
#include "core/geometry/similarity.h"

namespace tessera {

struct PlacedPiece {
  std::string shape;             // its name
  Similarity canvas_from_shape;  // within the file's decimals
  bool locked = false;
  bool exact = false;  // the file says its pose exactly, too (start_pieces.h)
};

inline constexpr std::size_t kMostPieces = 1'000'000;  // as `stop.pieces` may say

/// In order of placement, kMostPieces at most. Throws InputError that names the file and what is wrong with it.
std::vector<PlacedPiece> read_placed_pieces(const std::string& dir);

/// The poses as they are read back from pieces.geojson.
std::vector<Placement> as_written(std::vector<Placement> placements);

}  // namespace tessera
