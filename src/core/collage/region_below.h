// Finds the region of a canvas in which a piece of an earlier result lies.
#pragma once

#include <cstdint>

#include "core/field/canvas.h"
#include "core/geometry/polygon.h"
#include "core/geometry/similarity.h"

namespace tessera {

/// The region that contains the largest part of the piece; the first region if none contains any. Counts cells of 1 px,
/// and larger ones for large pieces.
std::uint32_t region_below(const Canvas& canvas, const Outline& outline, const Similarity& canvas_from_shape);

}  // namespace tessera
