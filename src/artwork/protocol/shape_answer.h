// A shape from artwork, or the reason why there is none, as bytes sent by a drawer.
#pragma once

#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "artwork/artwork_shape.h"

namespace tessera {

using ShapeOrReason = std::variant<ArtworkShape, SkipReason>;

std::vector<std::uint8_t> encode_shape_answer(const ShapeOrReason& answer);

/// Throws std::runtime_error where the bytes are not from encode_shape_answer.
ShapeOrReason decode_shape_answer(std::span<const std::uint8_t> bytes);

}  // namespace tessera
