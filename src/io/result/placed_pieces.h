// pieces.geojson of a result read back, without its polygons.
#pragma once

#include <string>
#include <vector>

#include "core/collage/placement.h"
#include "core/geometry/similarity.h"

namespace tessera::io {

struct PlacedPiece {
  std::string shape;             // its name
  Similarity canvas_from_shape;  // within the file's decimals
  bool locked = false;
  bool exact = false;  // the file says its pose exactly, too (start_pieces.h)
};

/// In order of placement. Throws InputError that names the file and what is wrong with it.
std::vector<PlacedPiece> read_placed_pieces(const std::string& dir);

/// The poses as they are read back from pieces.geojson.
std::vector<Placement> as_written(std::vector<Placement> placements);

}  // namespace tessera::io
