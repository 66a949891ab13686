// An SVG's outlines as bytes, sent by a drawer.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "artwork/outlines/svg_outlines.h"

namespace tessera {

std::vector<std::uint8_t> encode_outlines(const SvgOutlines& outlines);

/// Throws std::runtime_error where the bytes are not from encode_outlines.
SvgOutlines decode_outlines(std::span<const std::uint8_t> bytes);

}  // namespace tessera
