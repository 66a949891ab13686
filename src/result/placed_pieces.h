// Reads pieces.geojson of a result back, without its polygons.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/collage/placement.h"
#include "core/geometry/similarity.h"

namespace tessera {

struct PlacedPiece {
  std::string shape;             // its name
  Similarity canvas_from_shape;  // with the decimals of the file
  bool locked = false;
  bool exact = false;  // the file has the exact pose, too (start_pieces.h)
};

inline constexpr std::size_t kMostPieces = 1'000'000;  // as in `stop.pieces`

/// The pieces in order of placement, at most kMostPieces. Throws InputError that names the file and what is wrong with it.
std::vector<PlacedPiece> read_placed_pieces(const std::string& dir);

/// The placements with their poses as pieces.geojson will give them back.
std::vector<Placement> as_written(std::vector<Placement> placements);

}  // namespace tessera
