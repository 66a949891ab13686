// pieces.geojson read back, as far as drawing needs it.
#pragma once

#include <string>
#include <vector>

#include "core/geometry/similarity.h"

namespace tessera::io {

/// canvas_from_shape of each piece in order of placement, within the file's decimals. Throws InputError that names the
/// file and what is wrong with it.
std::vector<Similarity> read_placed_pieces(const std::string& dir);

}  // namespace tessera::io
