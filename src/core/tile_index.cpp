#include "core/tile_index.h"

namespace tessera {

void TileIndex::Region::add(const Window& window) {
  const Window tiles = in_tiles(window);
  if (tiles == last_) return;
  last_ = tiles;
  for (int y = tiles.y0; y < tiles.y1; ++y) {
    for (int x = tiles.x0; x < tiles.x1; ++x) tiles_.push_back(tile(x, y));
  }
}

std::vector<TileIndex::Tile> TileIndex::Region::tiles() && {
  std::sort(tiles_.begin(), tiles_.end());
  tiles_.erase(std::unique(tiles_.begin(), tiles_.end()), tiles_.end());
  return std::move(tiles_);
}

void TileIndex::erase(Tile tile, std::uint32_t thing) {
  const auto found = things_.find(tile);
  std::vector<std::uint32_t>& things = found->second;
  *std::find(things.begin(), things.end(), thing) = things.back();
  things.pop_back();
  if (things.empty()) things_.erase(found);
}

void TileIndex::move(std::uint32_t thing, const std::vector<Tile>& before, const std::vector<Tile>& after) {
  auto old = before.begin();
  auto fresh = after.begin();
  while (old != before.end() || fresh != after.end()) {
    if (fresh == after.end() || (old != before.end() && *old < *fresh)) {
      erase(*old++, thing);
    } else if (old == before.end() || *fresh < *old) {
      insert(*fresh++, thing);
    } else {
      ++old;
      ++fresh;
    }
  }
}

Window TileIndex::in_tiles(const Window& w) {
  if (w.empty()) return {};
  return {tile_coordinate(w.x0), tile_coordinate(w.y0), tile_coordinate(w.x1 - 1) + 1, tile_coordinate(w.y1 - 1) + 1};
}

}  // namespace tessera
