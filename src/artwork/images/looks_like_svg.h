// Tells an SVG from an image.
#pragma once

#include <cstdint>
#include <span>

namespace tessera {

/// Whether the bytes are an XML document or gzipped data.
bool looks_like_svg(std::span<const std::uint8_t> bytes);

}  // namespace tessera
