// In which of a canvas' regions a piece lies that no run placed there: one of an earlier result.
#pragma once

#include <cstdint>

#include "core/field/canvas.h"
#include "core/geometry/polygon.h"
#include "core/geometry/similarity.h"

namespace tessera {

/// The region that has most of the piece, the first one where none has any. Counted on cells of 1 px, and fewer of
/// large pieces.
std::uint32_t region_below(const Canvas& canvas, const Outline& outline, const Similarity& canvas_from_shape);

}  // namespace tessera
