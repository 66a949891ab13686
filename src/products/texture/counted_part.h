// Counts what the cells of a square of the canvas hold, along its rows.
#pragma once

#include <cstddef>
#include <vector>

#include "products/texture/layout_canvas.h"

namespace tessera {

/// Numbers of cells of the canvas.
struct CellCounts {
  int all = 0;
  int taken = 0;   // by an element
  int hole = 0;    // kHole, not taken
  int unlaid = 0;  // kHole or kOpen, not taken

  void add(const CellCounts& before, const CellCounts& until) {
    all += until.all - before.all;
    taken += until.taken - before.taken;
    hole += until.hole - before.hole;
    unlaid += until.unlaid - before.unlaid;
  }
};

class CountedPart {
 public:
  explicit CountedPart(const CanvasPart& part);

  /// The counts for one row: of the cells before each column, and last of all its cells.
  const CellCounts* before(int row) const { return &before_[std::size_t(row) * stride_]; }

 private:
  std::size_t stride_;
  std::vector<CellCounts> before_;
};

}  // namespace tessera
