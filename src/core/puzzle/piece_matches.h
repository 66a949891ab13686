// Which pieces of a puzzle may lie beside which, and how: pairs of corners from which the boundaries run alike.
#pragma once

#include <vector>

#include "core/geometry/similarity.h"
#include "core/puzzle/puzzle_piece.h"

namespace tessera {

struct PieceMatch {
  int piece = 0;  // the other one
  Similarity here_from_there;
  float length = 0;         // of the boundary that runs alike from the corner on
  bool whole_side = false;  // their next corners meet, too
};

/// Of each piece those that may lie beside it, a list each; (a, b) stands in both lists. The last piece may be a frame.
std::vector<std::vector<PieceMatch>> piece_matches(const std::vector<PuzzlePiece>& pieces, const PuzzleScale& scale);

}  // namespace tessera
