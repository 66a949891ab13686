// Finds the nodes of a window that lie near a piece. It works by blocks, as most blocks lie entirely on one side.
#pragma once

#include "core/field/piece_distance.h"
#include "core/geometry/bit_grid.h"

namespace tessera {

/// The nodes of `window` whose distance to the piece is below `limit_px`. Node (0, 0) of the result is the window's
/// first node. `origin` is the canvas position of node (0, 0) of the canvas.
BitGrid nodes_nearer_than(float limit_px, const PieceDistance& piece, Vec2 origin, const Window& window);

/// Finds these nodes only where `relevant_nodes` has a node; elsewhere the result may be wrong. Late in a collage few nodes
/// matter.
BitGrid nodes_nearer_than(float limit_px, const PieceDistance& piece, Vec2 origin, const Window& window,
                          const BitGrid& relevant_nodes);

}  // namespace tessera
