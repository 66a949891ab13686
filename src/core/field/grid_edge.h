// The edges of the node grid, each between horizontal or vertical neighbours.
#pragma once

#include <cstdint>

#include "core/geometry/grid.h"

namespace tessera {

struct GridEdge {
  int x = 0;
  int y = 0;
  bool down = false;  // true: from (x, y) to (x, y + 1); false: to (x + 1, y)

  /// Edges are numbered row by row: 2 (y · width + x), plus 1 if `down`.
  static GridEdge of(std::uint32_t number, int width) {
    return {int((number >> 1) % std::uint32_t(width)), int((number >> 1) / std::uint32_t(width)), (number & 1) != 0};
  }
  std::uint32_t number(int width) const {
    return 2 * (std::uint32_t(y) * std::uint32_t(width) + std::uint32_t(x)) + down;
  }

  /// Whether at least one of its two nodes lies in the window.
  bool touches(const Window& w) const {
    return w.contains(x, y) || (down ? w.contains(x, y + 1) : w.contains(x + 1, y));
  }
};

}  // namespace tessera
