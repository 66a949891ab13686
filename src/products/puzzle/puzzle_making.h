// A picture or a shape cut into the pieces of a puzzle, each a picture of its own, turned; and how they lay.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "artwork/drawers/drawers.h"
#include "files/new_folder.h"
#include "products/puzzle/puzzle_cut.h"

namespace tessera {

struct PuzzleRequest {
  std::string picture;  // JPEG, PNG, TIFF, WebP or BMP; or SVG: its silhouette is cut
  int pieces = 36;
  CutStyle style = CutStyle::tabs;
  std::uint64_t seed = 1;
};

struct MadePuzzle {
  int pieces = 0;
  int width_px = 0;
  int height_px = 0;
  std::string frame;           // name of the file that shows the outline of what was cut; empty: the whole picture
  std::vector<NewFile> files;  // all
};

/// Fewest and most pieces of a puzzle, and the smallest in px of the picture.
inline constexpr int kFewestPuzzlePieces = 2;
inline constexpr int kMostPuzzlePieces = 2'000;
inline constexpr int kSmallestPuzzlePiece_px = 40;

/// pieces/piece_001.png and so on, numbered in a random order, each turned by a random angle; and truth/pieces.geojson,
/// which says where each lay, px of the picture; of a shape frame.svg, too, its outline on a page of that size. Nothing
/// is written. Throws InputError where the picture is of no use or too small for the pieces or has several parts or
/// holes; EnvironmentError.
MadePuzzle make_puzzle(const PuzzleRequest& request, Drawers& drawers);

}  // namespace tessera
