// What a thumbnail of a library may be, told from its bytes before anyone decodes it: a PNG may claim any size and hold
// compressed texts and profiles.
#pragma once

#include <cstdint>
#include <span>

namespace tessera {

/// A PNG of 8-bit RGBA, not interlaced, layout::kMaxThumbnailSide_px a side or less, made of its header, its pixels
/// and its end alone, as silhouette.cpp writes it. Checksums and pixels are the decoder's matter.
bool is_thumbnail_png(std::span<const std::uint8_t> bytes);

}  // namespace tessera
