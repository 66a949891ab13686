#include "io/result/artwork_original.h"

#include "core/base/error.h"
#include "io/artwork/artwork_render.h"

namespace tessera::io {

std::vector<std::uint8_t> artwork_original(const Artwork& artwork) {
  if (!artwork.original.empty()) return artwork.original;
  if (artwork.path.empty()) return {};
  try {
    return read_artwork_file(artwork.path);
  } catch (const InputError&) {
    return {};
  }
}

Similarity artwork_from_shape(const Artwork& artwork) {
  return {artwork.unit_px, 0, artwork.centroid_px.x, artwork.centroid_px.y};
}

}  // namespace tessera::io
