// Finds which pieces of a puzzle may lie beside which, and how: pairs of corners from which the boundaries agree.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "core/base/stop.h"
#include "core/geometry/similarity.h"
#include "products/puzzle/pieces/puzzle_piece.h"

namespace tessera {

struct PieceMatch {
  int piece = 0;  // the other piece
  Similarity here_from_there;
  float worth = 0;          // length of the agreeing boundary, changed by how its pictures agree
  bool whole_side = false;  // the next corners of both meet, too
  int corner_ahead = -1;    // corner of this piece whose side ahead agrees; -1: it is a side back
  float apart = 0;          // root mean square distance of the boundaries there, in parts of the tolerance
};

/// For each piece, a list of the pieces that may lie beside it; the match (a, b) is in both lists. The last piece may be a
/// frame. `watch` is called before each corner with the number of the piece.
std::vector<std::vector<PieceMatch>> piece_matches(const std::vector<PuzzlePiece>& pieces, const PuzzleScale& scale,
                                                   const std::function<void(std::size_t)>& watch);

struct SideMatch {
  int piece = 0;
  PieceMatch match;

  /// The length of agreeing boundary; it counts less the farther apart the boundaries are.
  float length() const { return match.worth * (1 - match.apart); }
};

/// The longest match ahead from each corner of `sample` pieces (all, if there are fewer), if any is a whole side.
/// `check_stop` is called before each corner.
std::vector<SideMatch> sampled_sides(const std::vector<PuzzlePiece>& pieces, std::size_t sample,
                                     const PuzzleScale& scale, const StopCheck& check_stop);

/// Finds the matches with the last piece, a frame, again, because the frame has changed.
void match_frame_anew(const std::vector<PuzzlePiece>& pieces, const PuzzleScale& scale,
                      std::vector<std::vector<PieceMatch>>& matches, const std::function<void(std::size_t)>& watch);

}  // namespace tessera
