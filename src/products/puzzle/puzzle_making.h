// Cuts a picture or a shape into the pieces of a puzzle, each a turned picture of its own, and notes where they lay.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "artwork/drawers/drawers.h"
#include "files/new_folder.h"
#include "products/puzzle/puzzle_cut.h"

namespace tessera {

struct PuzzleRequest {
  std::string picture;  // JPEG, PNG, TIFF, WebP or BMP; or an SVG, whose silhouette is cut
  int pieces = 36;
  CutStyle style = CutStyle::tabs;
  std::uint64_t seed = 1;
};

struct MadePuzzle {
  int pieces = 0;
  int width_px = 0;
  int height_px = 0;
  std::string frame;           // name of the file with the outline that was cut; empty: the whole picture
  std::vector<NewFile> files;  // all files
};

/// The fewest and most pieces of a puzzle, and the smallest piece in px of the picture.
inline constexpr int kFewestPuzzlePieces = 2;
inline constexpr int kMostPuzzlePieces = 2'000;
inline constexpr int kSmallestPuzzlePiece_px = 40;

/// Makes pieces/piece_001.png and so on, numbered in a random order, each turned by a random angle. Also makes
/// truth/pieces.geojson with their former poses, px of the picture; and for a shape frame.svg, its outline on a page of
/// that size. It writes nothing. Throws InputError where the picture is unusable, too small for the pieces, or has several
/// parts or holes; EnvironmentError.
MadePuzzle make_puzzle(const PuzzleRequest& request, Drawers& drawers);

}  // namespace tessera
