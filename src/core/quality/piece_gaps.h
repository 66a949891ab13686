// How far pieces lie from each other, polygon to polygon.
#pragma once

#include <optional>
#include <vector>

#include "core/geometry/period.h"
#include "core/quality/judged_piece.h"

namespace tessera {

struct PieceGaps {
  std::optional<double> smallest_px;  // between two pieces; 0: some touch or overlap. Nothing: there are no two
  double alone = 0;                   // share of the pieces that no other comes nearer than the reach
};

/// True distances; a piece in the hole of another is as far from it as from the hole's edge. On a seamless canvas all
/// images count, a piece's own, too.
PieceGaps piece_gaps(const std::vector<JudgedPiece>& pieces, const Period& period, float reach_px);

}  // namespace tessera
