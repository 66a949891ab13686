// Draws an artwork file at any size, for the final picture. Artwork is untrusted: svg_page.h and raster_page.h say what
// is refused. A hostile SVG can take any time and memory, so Drawers::render (drawers.h) calls this in a process with
// limits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <opencv2/core.hpp>
#include <span>
#include <string>
#include <vector>

#include "artwork/images/artwork_page.h"

namespace tessera {

inline constexpr std::size_t kMaxArtworkFileBytes = 20u << 20;
inline constexpr int kMaxArtworkSide_px = 8192;

/// The artwork's page (SVG) or picture as straight (not premultiplied) BGRA, CV_8UC4. Its longest side is exactly
/// longest_side_px (1..kMaxArtworkSide_px), the other one is rounded up. Both axes have the same scale, and the upper
/// left corner stays: a point in Artwork's frame is multiplied by longest_side_px / max(Artwork::width_px, height_px).
/// `path` is used in messages only; the content decides the format. Throws InputError where the bytes are no artwork or
/// exceed a limit.
cv::Mat render_artwork(std::span<const std::uint8_t> bytes, const std::string& path, int longest_side_px,
                       Background background = Background::cut_out);

/// Reads the whole file. Throws InputError where it cannot be read or is larger than kMaxArtworkFileBytes.
std::vector<std::uint8_t> read_artwork_file(const std::string& path);

}  // namespace tessera
