#include "render/pieces/artwork_original.h"

#include <filesystem>

#include "artwork/artwork_render.h"
#include "artwork/images/formats/orientation.h"
#include "artwork/images/sha256.h"
#include "core/base/error.h"
#include "files/regular_file.h"

namespace tessera {
namespace {

/// Reads the original at this path. It follows a link to a regular file anywhere, because the hash decides. The hashed
/// bytes are those that are drawn; the file is not opened a second time.
ArtworkOriginal original_at(const std::string& path, const Sha256& sha256) {
  std::error_code error;
  if (path.empty() || !std::filesystem::exists(path, error)) return {{}, kOriginalMissing};
  try {
    std::vector<std::uint8_t> bytes = read_regular_file(path, kMaxArtworkFileBytes);
    if (sha256_of(bytes) != sha256) return {{}, kOriginalChanged};
    return {std::move(bytes), {}};
  } catch (const InputError&) {
    return {{}, kOriginalNoFile};
  }
}

/// The original in a file.
ArtworkOriginal found_original(const Artwork& artwork) {
  if (!artwork.original.empty()) return {artwork.original, {}};
  if (artwork.path.empty()) return {{}, kOriginalMissing};
  if (!artwork.sha256) return {{}, kOriginalUnknown};
  ArtworkOriginal first = original_at(artwork.path, *artwork.sha256);
  if (!first.bytes.empty()) return first;
  ArtworkOriginal second = original_at(artwork.path_beside_library, *artwork.sha256);
  const bool second_says_more = !second.bytes.empty() || first.reason == kOriginalMissing;
  return second_says_more ? second : first;
}

/// Whether the shape's outline was made before pictures were turned by their EXIF data, and this one would be turned.
bool is_turned_now(const Artwork& artwork, const std::vector<std::uint8_t>& bytes) {
  constexpr int kTurningReader = 2;
  return artwork.reader < kTurningReader && orientation_in_file(bytes) != 1;
}

}  // namespace

ArtworkOriginal artwork_original(const Artwork& artwork) {
  ArtworkOriginal original = found_original(artwork);
  if (is_turned_now(artwork, original.bytes)) return {{}, kOriginalReadOtherwise};
  return original;
}

Similarity artwork_from_shape(const Artwork& artwork) {
  return {artwork.unit_px, 0, artwork.centroid_px.x, artwork.centroid_px.y};
}

std::vector<std::vector<Vec2>> as_drawn(const Artwork& artwork, std::vector<std::vector<Vec2>> curves) {
  if (!artwork.mirrored) return curves;
  for (std::vector<Vec2>& curve : curves) {
    for (Vec2& p : curve) p.x = -p.x;
  }
  return curves;
}

}  // namespace tessera
