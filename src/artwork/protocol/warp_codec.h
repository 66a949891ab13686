// A warp as bytes, sent to a drawer.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/deform/warp.h"

namespace tessera {

/// Most nodes of a warp: a square of 1,024 x 1,024.
inline constexpr std::int64_t kMostWarpNodes = std::int64_t(1) << 20;
/// Longest displacement in a warp, as large as a page may be.
inline constexpr float kMostWarpLength = 1e6f;

/// The bytes of the warp. Throws InputError where the warp is invalid: fewer nodes than a cell has or more than
/// kMostWarpNodes, cells that do not fit the nodes, numbers that are not finite or beyond kMostWarpLength, a step that
/// is not above 0.
std::vector<std::uint8_t> encode_warp(const Warp& warp);

/// Throws InputError where the bytes are not from encode_warp.
Warp decode_warp(std::span<const std::uint8_t> bytes);

}  // namespace tessera
