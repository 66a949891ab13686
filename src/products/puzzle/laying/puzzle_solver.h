// Lays the pieces of a puzzle, each once, as they were cut. The greedy choice of the paper, section 5 ("Puzzle Solving"),
// ends in local optima where pieces are not unique. Here the surest places come first, and several arrangements are
// followed at a time.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "core/geometry/similarity.h"
#include "core/geometry/vec2.h"
#include "products/puzzle/pieces/piece_picture.h"

namespace tessera {

/// The progress of solving; pieces are laid once or several times.
struct PuzzleProgress {
  bool laying = false;  // false: it searches for pieces that fit each other
  std::size_t done = 0;
  std::size_t of = 0;
};

struct PuzzleInput {
  std::vector<std::vector<Vec2>> pieces;  // polygons in one unit, interior on the left, with some area
  std::vector<Vec2> frame;                // a polygon in the same unit; empty: none
  // false: the frame may have another size, or pieces may be missing or foreign
  bool frame_fits = true;
  std::vector<PiecePicture> pictures = {};  // one for each piece, or none
  // called often; what it throws ends the work
  std::function<void(const PuzzleProgress&)> watch = [](const PuzzleProgress&) {};
};

/// The largest part of all boundaries beside narrow gaps at which pieces count as fitting.
inline constexpr double kMostPuzzleGaps = 0.02;

struct PuzzleSolution {
  std::vector<std::optional<Similarity>> poses;  // puzzle_from_piece of each piece; empty: no place was found
  /// puzzle_from_piece of all pieces, where they fit each other but not all of them fit into the frame; otherwise empty.
  std::vector<Similarity> without_frame = {};
  int placed = 0;
  double scale = 1;    // of the pieces in the frame: they lie in frame / scale, in their unit
  double erosion = 0;  // how much smaller the pieces are all around than they were cut (likely_erosions)
  int undecided = 0;   // pieces of one outline that the pictures do not tell apart (piece_exchange.h)
  double gaps = 0;     // part of the whole boundary beside narrow gaps: 0 where pieces fit
};

/// The best arrangement that was found, which may lack pieces. In a frame no piece reaches farther beyond the edge than
/// outlines are exact, and poses are in the frame's coordinates; otherwise in those of the piece that was laid first. The
/// same input gives the same solution.
PuzzleSolution solve_puzzle(const PuzzleInput& input);

}  // namespace tessera
