// The bytes of models in a library file (segment_layout.h).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "library/storage/segment_layout.h"

namespace tessera {

/// The bytes of a segment. `models` have the levels of `kind`; there are kSegmentShapes of them, or fewer at the end of the
/// library. `owners` are in the same order.
std::vector<std::uint8_t> segment_bytes(const SegmentKind& kind, std::span<const ShapeModel> models,
                                        std::span<const SegmentOwner> owners);

}  // namespace tessera
