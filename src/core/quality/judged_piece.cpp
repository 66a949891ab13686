#include "core/quality/judged_piece.h"

#include "core/collage/placed_outlines.h"

namespace tessera {

std::vector<JudgedPiece> judged_pieces(const std::vector<Placement>& placements,
                                       const std::function<const Shape&(ShapeId)>& shape) {
  std::vector<JudgedPiece> pieces;
  for (const Placement& p : placements) {
    const Shape& placed = shape(p.shape);
    const Similarity& t = p.canvas_from_shape;
    pieces.push_back({placed_outline(placed.outline, t), placed.name, t.translation(), t.scale()});
  }
  return pieces;
}

}  // namespace tessera
