// The file a shape was made from, for the outputs: from the library itself or from where it was at build time.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/similarity.h"
#include "core/shape/shape.h"

namespace tessera::io {

/// The embedded file, else the one at Artwork::path. Empty where there is neither (any more): outputs then make do with
/// the thumbnail, a collage never fails because someone tidied up the clip art.
std::vector<std::uint8_t> artwork_original(const Artwork& artwork);

/// Where shape coordinates lie in the artwork frame.
Similarity artwork_from_shape(const Artwork& artwork);

}  // namespace tessera::io
