// Which pieces of a puzzle may lie beside which, and how: pairs of corners from which the boundaries run alike.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "core/base/stop.h"
#include "core/geometry/similarity.h"
#include "products/puzzle/pieces/puzzle_piece.h"

namespace tessera {

struct PieceMatch {
  int piece = 0;  // the other one
  Similarity here_from_there;
  float worth = 0;          // length of the boundary that runs alike, more or less by how its pictures agree
  bool whole_side = false;  // their next corners meet, too
  int corner_ahead = -1;    // of this piece, from which the side ahead runs alike; -1: it is the side back
  float apart = 0;          // root mean square distance of the boundaries there, parts of the tolerance
};

/// Of each piece those that may lie beside it, a list each; (a, b) stands in both lists. The last piece may be a frame.
/// `watch` is called before each corner with the number of the piece.
std::vector<std::vector<PieceMatch>> piece_matches(const std::vector<PuzzlePiece>& pieces, const PuzzleScale& scale,
                                                   const std::function<void(std::size_t)>& watch);

struct SideMatch {
  int piece = 0;
  PieceMatch match;

  /// How far the boundaries run alike; it counts less the farther apart they are.
  float length() const { return match.worth * (1 - match.apart); }
};

/// Of `sample` pieces (all, if there are fewer) the longest match ahead from each corner, if any is a whole side.
/// `check_stop` is called before each corner.
std::vector<SideMatch> sampled_sides(const std::vector<PuzzlePiece>& pieces, std::size_t sample,
                                     const PuzzleScale& scale, const StopCheck& check_stop);

/// The matches with the last piece, a frame, once more, as another frame stands there now.
void match_frame_anew(const std::vector<PuzzlePiece>& pieces, const PuzzleScale& scale,
                      std::vector<std::vector<PieceMatch>>& matches, const std::function<void(std::size_t)>& watch);

}  // namespace tessera
