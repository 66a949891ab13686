// The distance from a piece to the nearest other piece of the same shape.
#pragma once

#include <optional>
#include <vector>

#include "core/geometry/period.h"
#include "core/quality/judged_piece.h"

namespace tessera {

/// The median of the distance, px, from a piece's centre to the nearest centre of another piece of the same name. It is
/// taken over the pieces whose shape has a name. On a seamless canvas the other piece's images count, the piece's own
/// do not. Empty if half of the pieces are the only ones of their shape.
std::optional<double> median_copy_distance_px(const std::vector<JudgedPiece>& pieces, const Period& period);

}  // namespace tessera
