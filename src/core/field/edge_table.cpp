#include "core/field/edge_table.h"

namespace tessera {

EdgeTable::EdgeTable(int width, int height)
    : width_(width),
      height_(height),
      tiles_((width + kTile_nodes - 1) / kTile_nodes, (height + kTile_nodes - 1) / kTile_nodes) {}

int EdgeTable::find(const GridEdge& e) const {
  const Tile& tile = tiles_(e.x / kTile_nodes, e.y / kTile_nodes);
  return tile.used == 0 ? kNone : tile.value[place(e)];
}

void EdgeTable::insert(const GridEdge& e, int value) {
  Tile& tile = tiles_(e.x / kTile_nodes, e.y / kTile_nodes);
  if (tile.used++ == 0) tile.value.assign(2 * kTile_nodes * kTile_nodes, kNone);
  tile.value[place(e)] = value;
}

void EdgeTable::erase(const GridEdge& e) {
  Tile& tile = tiles_(e.x / kTile_nodes, e.y / kTile_nodes);
  tile.value[place(e)] = kNone;
  if (--tile.used == 0) tile.value = {};
}

}  // namespace tessera
