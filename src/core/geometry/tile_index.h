// A spatial index from the tiles of an unbounded plane of nodes to the things in each tile.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/geometry/grid.h"

namespace tessera {

class TileIndex {
 public:
  using Tile = std::uint64_t;

  /// The tiles of a region that grows window by window.
  class Region {
   public:
    void add(const Window& window) {
      const Window tiles = in_tiles(window);
      if (tiles == last_) return;
      last_ = tiles;
      add_tiles();
    }
    /// The tiles, ascending, each once.
    std::vector<Tile> tiles() &&;

   private:
    void add_tiles();

    Window last_;  // in tiles; successive windows often lie in the same tiles
    std::vector<Tile> tiles_;
  };

  void insert(Tile tile, std::uint32_t thing) { things_[tile].push_back(thing); }
  void erase(Tile tile, std::uint32_t thing);
  /// Moves the thing from the tiles `before` to the tiles `after`, both ascending.
  void move(std::uint32_t thing, const std::vector<Tile>& before, const std::vector<Tile>& after);

  static Tile tile_at(int x, int y) { return tile(tile_coordinate(x), tile_coordinate(y)); }

  /// Calls f(thing) for each thing of each tile that overlaps the window. A thing in several tiles comes once for each.
  template <class F>
  void each(const Window& window, F f) const {
    const Window tiles = in_tiles(window);
    for (int y = tiles.y0; y < tiles.y1; ++y) {
      for (int x = tiles.x0; x < tiles.x1; ++x) {
        const auto found = things_.find(tile(x, y));
        if (found == things_.end()) continue;
        for (const std::uint32_t thing : found->second) f(thing);
      }
    }
  }

 private:
  static constexpr int kTileBits = 5;  // a tile is 32 nodes wide, a piece some tiles

  static int tile_coordinate(int node) { return node >> kTileBits; }
  static Tile tile(int x, int y) { return Tile(std::uint32_t(y)) << 32 | std::uint32_t(x); }
  static Window in_tiles(const Window& w) {
    if (w.empty()) return {};
    return {tile_coordinate(w.x0), tile_coordinate(w.y0), tile_coordinate(w.x1 - 1) + 1, tile_coordinate(w.y1 - 1) + 1};
  }

  std::unordered_map<Tile, std::vector<std::uint32_t>> things_;
};

}  // namespace tessera
