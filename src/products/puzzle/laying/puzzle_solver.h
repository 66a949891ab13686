// Lays the pieces of a puzzle beside each other, each once, as they were cut. Paper, section 5 ("Puzzle Solving"),
// whose greedy choice ends in local optima where pieces are not unique; here what is surest comes first, and several
// arrangements are followed at a time.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "core/geometry/similarity.h"
#include "core/geometry/vec2.h"
#include "products/puzzle/pieces/piece_picture.h"

namespace tessera {

/// How far it is; pieces are laid once or several times.
struct PuzzleProgress {
  bool laying = false;  // else it is looked for what fits what
  std::size_t done = 0;
  std::size_t of = 0;
};

struct PuzzleInput {
  std::vector<std::vector<Vec2>> pieces;    // polygons in one unit, interior on the left, of some area
  std::vector<Vec2> frame;                  // the same, in that unit; empty: none
  bool frame_fits = true;                   // false: it may be of another size, as pieces may be missing or foreign
  std::vector<PiecePicture> pictures = {};  // one of each piece, or none
  std::function<void(const PuzzleProgress&)> watch = [](const PuzzleProgress&) {};  // often; what it throws ends it
};

/// Part of all boundaries beside narrow gaps up to which pieces count as fitting.
inline constexpr double kMostPuzzleGaps = 0.02;

struct PuzzleSolution {
  std::vector<std::optional<Similarity>> poses;  // puzzle_from_piece, of each piece; nothing: no place was found
  /// puzzle_from_piece of all pieces where they fit each other, but not all of them in the frame; empty else.
  std::vector<Similarity> without_frame = {};
  int placed = 0;
  double scale = 1;    // of the pieces in the frame: it is frame / scale, in their unit, that they lie in
  double erosion = 0;  // how much smaller all round pieces are than they were cut (likely_erosions)
  int undecided = 0;   // pieces of one outline that the pictures do not tell apart (piece_exchange.h)
  double gaps = 0;     // part of the boundary of all that is beside a narrow gap: 0 where pieces fit
};

/// The best arrangement that was found, which need not hold all pieces. In a frame no piece reaches farther beyond its
/// edge than outlines are exact, and poses are in its coordinates; else in those of the piece that was laid first. The
/// same input gives the same solution.
PuzzleSolution solve_puzzle(const PuzzleInput& input);

}  // namespace tessera
