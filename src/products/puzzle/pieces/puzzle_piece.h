// A puzzle piece as it is matched: its outline at the scale of all pieces, and its corners with the boundary on either
// side of them.
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry/polygon_index.h"
#include "core/geometry/vec2.h"
#include "products/puzzle/pieces/piece_picture.h"

namespace tessera {

/// Lengths by which pieces of one puzzle are compared, in their common unit; all follow from the size of a usual piece.
struct PuzzleScale {
  float piece = 0;                // square root of the median area
  float step = 0;                 // between points of a profile
  float tolerance = 0;            // by which boundaries that belong together may differ
  std::size_t most_corners = 64;  // of a piece, the sharpest; drawings that are no puzzle may have any number
  float contrast = 0;             // mean distance of the pictures' colours in two places; 0: they say nothing

  /// Of the areas of the pieces, one at least.
  static PuzzleScale of(std::vector<double> areas);
};

/// Where the boundary turns sharply, and how it goes on from there, PuzzleScale::step apart: `ahead` with the
/// interior on its left, `back` with the interior on its right. Both begin with the corner itself.
struct PuzzleCorner {
  std::vector<Vec2> ahead;
  std::vector<Vec2> back;
  float side_ahead = 0;  // steps to the next corner
  float side_back = 0;
};

struct PuzzlePiece {
  PolygonIndex outline;
  std::vector<Vec2> points = {};      // even arclength, about one step apart
  std::vector<Vec2> directions = {};  // of the boundary there, unit length, interior on the left
  std::vector<float> bends = {};      // how bent the boundary is there: 0 for a straight line, 1 for a bend
  std::vector<float> weights = {};    // what agreement there says: a bend is not found by chance, a straight line is
  float point_length = 0;             // of the boundary that each of them stands for
  std::vector<PuzzleCorner> corners = {};
  double area = 0;
  Vec2 centre = {};  // of the area
  float radius = 0;  // farthest point from it
  const PiecePicture* picture = nullptr;
  Vec2 deepest = {};  // about the point that is farthest from the boundary
};

/// `polygon`: interior on its left. A frame, which is to be filled, is what lies round it: its polygon runs the other
/// way, and its area is negative.
PuzzlePiece puzzle_piece(const std::vector<Vec2>& polygon, const PuzzleScale& scale);

}  // namespace tessera
