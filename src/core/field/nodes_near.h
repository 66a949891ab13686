// Which nodes of a window lie near a piece, found by blocks: most of them are far on one side.
#pragma once

#include "core/field/piece_distance.h"
#include "core/geometry/bit_grid.h"

namespace tessera {

/// The nodes of `window` whose distance to the piece is below `limit_px`; node (0, 0) of the result is the window's
/// first. `origin` is the canvas position of node (0, 0) of the canvas.
BitGrid nodes_nearer_than(float limit_px, const PieceDistance& piece, Vec2 origin, const Window& window);

/// The same, but right only where `asked` has a node: late in a collage little is asked.
BitGrid nodes_nearer_than(float limit_px, const PieceDistance& piece, Vec2 origin, const Window& window,
                          const BitGrid& asked);

}  // namespace tessera
