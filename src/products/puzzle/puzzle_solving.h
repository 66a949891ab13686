// Solves a library of puzzle pieces, and writes their poses and the job of a collage that shows them.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "products/puzzle/laying/puzzle_solver.h"
#include "products/puzzle/puzzle_truth.h"

namespace tessera {

struct SolvingRequest {
  std::string library;
  std::optional<std::vector<int>> frame_px;  // width and height; empty: as large as the laid pieces
  std::string frame_file;  // SVG or image whose silhouette is the frame, in the box of frame_px; empty: a rectangle
  // px of the canvas for one px of the pieces; empty: they reach the frame's edges, or 1
  std::optional<double> scale;
  std::string truth;           // folder with a pieces.geojson; empty: none
  std::string job;             // the file to write
  bool replace = false;        // replace files of these names that belong to another puzzle
  bool outlines_only = false;  // ignore the pictures on the pieces
  std::function<void(const PuzzleProgress&)> watch = [](const PuzzleProgress&) {};  // PuzzleInput::watch
};

struct SolvedPuzzle {
  int width_px = 0;
  int height_px = 0;
  double scale = 1;
  std::size_t pieces = 0;
  std::size_t placed = 0;
  std::vector<std::string> left_over;  // names
  /// Size of the smallest rectangle round all pieces as they fit each other, at the given scale, or 1. 0 where there is no
  /// frame, or where they do not all fit each other.
  int loose_width_px = 0;
  int loose_height_px = 0;
  int undecided = 0;                         // PuzzleSolution::undecided
  double gaps = 0;                           // PuzzleSolution::gaps
  double covered = 0;                        // area of the placed pieces, as a part of the frame or the canvas
  double filled = 0;                         // the same for the pieces as they were cut
  double erosion_px = 0;                     // PuzzleSolution::erosion, px of the canvas
  std::optional<PuzzleAgreement> agreement;  // with the truth, if it is given
};

inline constexpr std::size_t kMostSolvedPieces = 2'000;

/// The path of the file beside the job with the poses of the pieces.
std::string solution_path(const std::string& job);

/// Solves the puzzle and writes the job and the solution, each whole or not at all. Nothing is laid beyond the frame, if
/// there is one; pieces that find no place in it are left over. Throws InputError where the library is unusable (too many
/// pieces, holes, no known sizes), where none of its pieces fit each other, or where files of another kind are there;
/// EnvironmentError.
SolvedPuzzle write_solved_puzzle(const SolvingRequest& request);

}  // namespace tessera
