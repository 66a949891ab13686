// Models as they lie in a library file (segment_layout.h).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "library/storage/segment_layout.h"

namespace tessera {

/// `models`: with the levels of `kind`, kSegmentShapes of them, or what is left at the end of the library. `owners`: in
/// the same order.
std::vector<std::uint8_t> segment_bytes(const SegmentKind& kind, std::span<const ShapeModel> models,
                                        std::span<const SegmentOwner> owners);

}  // namespace tessera
