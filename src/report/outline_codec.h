// The outlines of pieces as compact bytes for a page. web/src/data.ts (blocks `outlines`, `contact` and `canvas`) has the
// page's side.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/polygon.h"
#include "core/quality/judged_piece.h"

namespace tessera {

/// Appends one piece: its number of rings; for each ring its number of points and their steps in units of 1/8 px, as
/// variable-length numbers. The first step of the first ring counts from (0, 0), that of a later ring from the last point
/// before.
void append_outline(const std::vector<std::vector<Vec2>>& rings, std::vector<std::uint8_t>& bytes);

struct PieceBlocks {
  std::vector<std::uint8_t> outlines;
  std::vector<std::uint8_t> contact;
};

/// The pieces' outlines without the points that change them by a tenth of a px or less, and for each point that stays the
/// mean distance of the boundary from there to the next one, units of 1/16 px, 255 beyond `reach_px`. `distances_px`:
/// boundary_distances_px() of the pieces with this reach.
PieceBlocks piece_blocks(const std::vector<JudgedPiece>& pieces, const std::vector<float>& distances_px,
                         float reach_px);

}  // namespace tessera
