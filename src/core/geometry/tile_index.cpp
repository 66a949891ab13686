#include "core/geometry/tile_index.h"

namespace tessera {

void TileIndex::Region::add_tiles() {
  for (int y = last_.y0; y < last_.y1; ++y) {
    for (int x = last_.x0; x < last_.x1; ++x) tiles_.push_back(tile(x, y));
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

}  // namespace tessera
