// Scanline fill of an outline on a grid: finds the cells whose centre is inside.
//
// Grid frame: cell (i, j) is [i, i + 1) x [j, j + 1), its centre (i + 0.5, j + 0.5). For supersampling the caller
// scales the similarity: a grid with n cells per canvas px is n times canvas_from_shape.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/grid.h"
#include "core/geometry/polygon.h"
#include "core/geometry/similarity.h"

namespace tessera {

/// Cells [x0, x1) of row y.
struct Span {
  int y = 0;
  int x0 = 0;
  int x1 = 0;

  friend bool operator==(const Span&, const Span&) = default;
};

/// The smallest window that contains every cell the outline reaches.
Window bounding_window(const Outline& outline, const Similarity& grid_from_shape);

/// Even-odd fill of the outline (holes stay free), clipped to `window`; spans in order of y, then x. If two outlines
/// have a common edge, a centre on it belongs to exactly one of them.
std::vector<Span> fill_spans(const Outline& outline, const Similarity& grid_from_shape, const Window& window);

/// A grid of `window`'s size with 1 in each cell whose centre is inside, and 0 elsewhere. Node (0, 0) is the window's
/// upper left cell.
Grid<std::uint8_t> rasterise(const Outline& outline, const Similarity& grid_from_shape, const Window& window);

}  // namespace tessera
