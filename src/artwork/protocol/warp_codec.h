// A warp as bytes for the way to a drawer.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/deform/warp.h"

namespace tessera {

/// As many as a square of 1,024 nodes.
inline constexpr std::int64_t kMostWarpNodes = std::int64_t(1) << 20;
/// Of what a warp moves: as large as a page may be.
inline constexpr float kMostWarpLength = 1e6f;

/// Throws InputError where the warp is none: fewer nodes than a cell has or more than kMostWarpNodes, cells that do not fit
/// them, numbers that are not finite or beyond kMostWarpLength, a step that is not above 0.
std::vector<std::uint8_t> encode_warp(const Warp& warp);

/// Throws InputError where the bytes are not what encode_warp gives.
Warp decode_warp(std::span<const std::uint8_t> bytes);

}  // namespace tessera
