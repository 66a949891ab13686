// Checks the bytes of a library's thumbnail before anyone decodes it: a PNG may claim any size and hold compressed texts
// and profiles.
#pragma once

#include <cstdint>
#include <span>

namespace tessera {

/// Whether it is a PNG as silhouette.cpp writes it: 8-bit RGBA, not interlaced, each side at most
/// layout::kMaxThumbnailSide_px, with header, pixels and end only. The decoder checks checksums and pixels.
bool is_thumbnail_png(std::span<const std::uint8_t> bytes);

}  // namespace tessera
