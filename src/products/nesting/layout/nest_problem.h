// What is nested: pieces at a fixed scale, each so many times, turned by angles from a list, on a strip or on sheets;
// and how they came to lie.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "products/nesting/layout/nest_polygon.h"

namespace tessera {

struct NestItem {
  NestRing outline;  // simple, of some area, either way round; what lies in its holes is its own
  std::vector<double> angles_deg;
  int demand = 1;
};

/// The strip goes from 0 to `height` in y, and in x from 0 to `length`.
struct NestProblem {
  std::vector<NestItem> items;
  double height = 0;
  double length = std::numeric_limits<double>::infinity();  // of a sheet; infinite: a strip, as short as it can be
  double spacing = 0;                                       // least distance between two pieces; none to the edges
};

struct NestedPiece {
  int item = 0;
  int angle = 0;    // in NestItem::angles_deg
  NestPoint shift;  // of the turned outline
  int sheet = 0;

  friend bool operator==(const NestedPiece&, const NestedPiece&) = default;
};

struct NestLayout {
  std::vector<NestedPiece> pieces;
  std::vector<int> left_over;  // how many of each item found no place
  int sheets = 0;
  double used_length = 0;  // of the last sheet, or of the strip
  int chain = 0;           // that found it
};

/// Where a piece's points lie.
inline NestPoint placed(const NestTurn& turn, const NestedPiece& piece, NestPoint p) {
  return turn.apply(p) + piece.shift;
}

/// The outline of a piece where it lies.
NestRing placed_outline(const NestProblem& problem, const NestedPiece& piece);

}  // namespace tessera
