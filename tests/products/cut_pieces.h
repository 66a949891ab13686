// A freshly cut puzzle, for tests that lay its pieces.
#pragma once

#include <algorithm>
#include <vector>

#include "core/geometry/closed_curve.h"
#include "core/geometry/polygon.h"
#include "products/puzzle/pieces/piece_erosion.h"
#include "products/puzzle/pieces/puzzle_contact.h"
#include "products/puzzle/puzzle_cut.h"

namespace tessera {

/// The pieces where they lay in the picture, as they were cut or smaller all round.
struct CutPieces {
  PuzzleScale scale;
  std::vector<PuzzlePiece> pieces;

  CutPieces(int count, CutStyle style, float lost) {
    std::vector<std::vector<Vec2>> polygons =
        cut_puzzle({.width_px = 1200, .height_px = 900, .pieces = count, .style = style, .seed = 3});
    std::vector<double> areas;
    for (std::vector<Vec2>& polygon : polygons) {
      polygon = grown_polygon(resampled_closed(polygon, 512), -lost);
      areas.push_back(signed_area(polygon));
    }
    scale = PuzzleScale::of(areas);
    for (const std::vector<Vec2>& polygon : polygons) pieces.push_back(puzzle_piece(polygon, scale));
  }

  PosedPiece posed(std::size_t i, Similarity pose = {1, 0, 0, 0}) const { return {&pieces[i], pose}; }

  /// The first piece after `i` that shares a side with it.
  std::size_t neighbour_of(std::size_t i) const {
    for (std::size_t j = i + 1; j < pieces.size(); ++j) {
      std::vector<Beside> beside(pieces[i].points.size(), Beside::nothing);
      see_neighbour(posed(i), posed(j), scale, beside);
      if (std::count(beside.begin(), beside.end(), Beside::nothing) < std::ptrdiff_t(beside.size() * 9 / 10)) return j;
    }
    return i;
  }
};

}  // namespace tessera
