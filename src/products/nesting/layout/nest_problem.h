// The problem of a nesting: pieces at a fixed scale, each in a number of copies and with a list of angles, on a strip or on
// sheets. And its layouts.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "products/nesting/layout/nest_polygon.h"

namespace tessera {

struct NestItem {
  NestRing outline;  // simple, with some area, in either direction; material in its holes is not used
  std::vector<double> angles_deg;
  int demand = 1;
};

/// The strip extends from 0 to `height` in y, and from 0 to `length` in x.
struct NestProblem {
  std::vector<NestItem> items;
  double height = 0;
  // of a sheet; infinite: a strip, to be as short as possible
  double length = std::numeric_limits<double>::infinity();
  double spacing = 0;  // least distance between two pieces; none to the edges
};

struct NestedPiece {
  int item = 0;
  int angle = 0;    // index in NestItem::angles_deg
  NestPoint shift;  // shift of the turned outline
  int sheet = 0;

  friend bool operator==(const NestedPiece&, const NestedPiece&) = default;
};

struct NestLayout {
  std::vector<NestedPiece> pieces;
  std::vector<int> left_over;  // how many pieces of each item found no place
  int sheets = 0;
  double used_length = 0;  // of the last sheet, or of the strip
  int chain = 0;           // number of the chain that found it
};

/// The place of a point of a piece in the layout.
inline NestPoint placed(const NestTurn& turn, const NestedPiece& piece, NestPoint p) {
  return turn.apply(p) + piece.shift;
}

/// The outline of a piece in the layout.
NestRing placed_outline(const NestProblem& problem, const NestedPiece& piece);

}  // namespace tessera
