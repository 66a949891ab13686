// A table from grid edges to numbers, for some of the edges. It finds the number of an edge, and all numbered edges of
// a window in a time that depends on the window's size only.
#pragma once

#include <cstdint>
#include <vector>

#include "core/field/grid_edge.h"

namespace tessera {

/// The table is dense within tiles; only tiles in use take memory.
class EdgeTable {
 public:
  static constexpr int kNone = -1;

  EdgeTable() = default;
  EdgeTable(int width, int height);

  /// The edge's number, or kNone.
  int find(const GridEdge& edge) const;
  /// `value` is not kNone, and the edge has no number yet.
  void insert(const GridEdge& edge, int value);
  void erase(const GridEdge& edge);

  /// Calls f(edge, value) for all edges that touch the window; f may not change the table.
  template <class F>
  void each(const Window& window, F f) const;

 private:
  static constexpr int kTile_nodes = 16;

  struct Tile {
    std::vector<int> value;  // empty if no edge has a number
    int used = 0;
  };

  static int place(const GridEdge& e) { return 2 * (e.y % kTile_nodes * kTile_nodes + e.x % kTile_nodes) + e.down; }

  int width_ = 0;
  int height_ = 0;
  Grid<Tile> tiles_;
};

template <class F>
void EdgeTable::each(const Window& window, F f) const {
  // An edge that begins left of the window or above it may end in it.
  const Window begins = Window{window.x0 - 1, window.y0 - 1, window.x1, window.y1}.intersected({0, 0, width_, height_});
  if (begins.empty()) return;
  for (int ty = begins.y0 / kTile_nodes; ty <= (begins.y1 - 1) / kTile_nodes; ++ty) {
    for (int tx = begins.x0 / kTile_nodes; tx <= (begins.x1 - 1) / kTile_nodes; ++tx) {
      const Tile& tile = tiles_(tx, ty);
      for (int i = 0; i < int(tile.value.size()); ++i) {
        if (tile.value[i] == kNone) continue;
        const GridEdge e{tx * kTile_nodes + i / 2 % kTile_nodes, ty * kTile_nodes + i / 2 / kTile_nodes, i % 2 != 0};
        if (e.touches(window)) f(e, tile.value[i]);
      }
    }
  }
}

}  // namespace tessera
