// Counts which cells of a canvas are covered by pieces. Areas and gaps are measured on these cells.
#pragma once

#include <cstdint>
#include <vector>

#include "core/field/canvas.h"
#include "core/geometry/grid.h"
#include "core/quality/judged_piece.h"

namespace tessera {

/// Cells of the canvas: which are covered by pieces, and which belong to the region to fill; 0 or 1.
struct CellCounts {
  int per_px = 1;  // 4 for canvases up to 4.2 million px, 2 up to 16.8 million px, else 1
  Window cells;    // node (0, 0) of the grids is the upper left cell
  Grid<std::uint8_t> covered;
  Grid<std::uint8_t> region;
  std::uint64_t layers = 0;  // sum, over the cells of the region, of the number of pieces that cover the cell
};

CellCounts count_cells(const Canvas& canvas, const std::vector<JudgedPiece>& pieces);

}  // namespace tessera
