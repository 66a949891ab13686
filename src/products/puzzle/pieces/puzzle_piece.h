// A puzzle piece in the form for matching: its outline at the scale of all pieces, and its corners with the boundary on
// either side.
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry/polygon_index.h"
#include "core/geometry/vec2.h"
#include "products/puzzle/pieces/piece_picture.h"

namespace tessera {

/// Lengths for comparing pieces of one puzzle, in their common unit. All follow from the size of a usual piece.
struct PuzzleScale {
  float piece = 0;                // square root of the median area
  float step = 0;                 // distance between points of a profile
  float tolerance = 0;            // by which boundaries that belong together may differ
  std::size_t most_corners = 64;  // of a piece, the sharpest ones; drawings that are no puzzle may have any number
  float contrast = 0;             // mean distance of the pictures' colours in two places; 0: pictures tell nothing

  /// The scale for pieces with these areas, of which there must be at least one.
  static PuzzleScale of(std::vector<double> areas);
};

/// A point where the boundary turns sharply, and the boundary from there on, in steps of PuzzleScale::step: `ahead` with
/// the interior on its left, `back` with the interior on its right. Both begin with the corner itself.
struct PuzzleCorner {
  std::vector<Vec2> ahead;
  std::vector<Vec2> back;
  float side_ahead = 0;  // steps to the next corner
  float side_back = 0;
};

struct PuzzlePiece {
  PolygonIndex outline;
  std::vector<Vec2> points = {};      // at equal arclengths, about one step apart
  std::vector<Vec2> directions = {};  // of the boundary there, unit length, interior on the left
  std::vector<float> bends = {};      // how bent the boundary is there: 0 for a straight line, 1 for a bend
  // weight of agreement there: a bend does not agree by chance, a straight line may
  std::vector<float> weights = {};
  float point_length = 0;  // length of the boundary that each point stands for
  std::vector<PuzzleCorner> corners = {};
  double area = 0;
  Vec2 centre = {};  // of the area
  float radius = 0;  // distance of the farthest point from the centre
  const PiecePicture* picture = nullptr;
  Vec2 deepest = {};  // about the point that is farthest from the boundary
};

/// `polygon`: interior on its left. A frame, which is to be filled, is the area around it: its polygon has the opposite
/// direction, and its area is negative.
PuzzlePiece puzzle_piece(const std::vector<Vec2>& polygon, const PuzzleScale& scale);

}  // namespace tessera
