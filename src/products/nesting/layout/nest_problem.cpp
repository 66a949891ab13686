#include "products/nesting/layout/nest_problem.h"

namespace tessera {

NestRing placed_outline(const NestProblem& problem, const NestedPiece& piece) {
  const NestItem& item = problem.items[std::size_t(piece.item)];
  const NestTurn turn = turn_of(item.angles_deg[std::size_t(piece.angle)]);
  NestRing ring;
  for (const NestPoint p : item.outline) ring.push_back(placed(turn, piece, p));
  return ring;
}

}  // namespace tessera
