// The distances between pieces, polygon to polygon.
#pragma once

#include <optional>
#include <vector>

#include "core/geometry/period.h"
#include "core/quality/judged_piece.h"

namespace tessera {

struct PieceGaps {
  std::optional<double> smallest_px;  // between two pieces; 0: some touch or overlap; empty: there are fewer than two
  double alone = 0;                   // fraction of the pieces with no other piece within the reach
};

/// Measures true distances. A piece in the hole of another has its distance from the hole's edge. On a seamless canvas
/// all images count, including a piece's own.
PieceGaps piece_gaps(const std::vector<JudgedPiece>& pieces, const Period& period, float reach_px);

}  // namespace tessera
