// pieces.geojson read back, as far as drawing needs it.
#pragma once

#include <string>
#include <vector>

#include "core/collage/placement.h"
#include "core/geometry/similarity.h"

namespace tessera::io {

/// canvas_from_shape of each piece in order of placement, within the file's decimals. Throws InputError that names the
/// file and what is wrong with it.
std::vector<Similarity> read_placed_pieces(const std::string& dir);

/// The poses as they are read back from pieces.geojson.
std::vector<Placement> as_written(std::vector<Placement> placements);

}  // namespace tessera::io
