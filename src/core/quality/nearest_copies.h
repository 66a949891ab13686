// How far one has to look from a piece to see its shape again.
#pragma once

#include <optional>
#include <vector>

#include "core/geometry/period.h"
#include "core/quality/judged_piece.h"

namespace tessera {

/// The median, over the pieces whose shape has a name, of the distance from a piece's centre to that of the nearest
/// other piece of this name, px. On a seamless canvas the other one's images count, its own do not. Nothing where half
/// of the pieces are the only ones of their shape.
std::optional<double> median_copy_distance_px(const std::vector<JudgedPiece>& pieces, const Period& period);

}  // namespace tessera
