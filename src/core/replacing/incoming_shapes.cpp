#include "core/replacing/incoming_shapes.h"

#include <algorithm>
#include <cstddef>
#include <set>

#include "core/replacing/draws.h"

namespace tessera {
namespace {

constexpr std::size_t kMostIncoming = 400;  // shapes, if the library is larger

}  // namespace

std::vector<IncomingShape> incoming_shapes(const StanceTable& stances, const ShapeSource& shapes,
                                           std::uint64_t random) {
  std::vector<IncomingShape> all;
  Draws draws(random);
  const std::size_t open = stances.open_shapes();
  const std::size_t count = std::min(open, kMostIncoming);
  float most_weight = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const ShapeId shape = stances.open_shape(std::uint32_t(open > kMostIncoming ? draws.below(open) : k));
    for (const Stance& stance : stances.of(stances.list(shape))) {
      all.push_back({shape, shapes.silhouette(shape), stance.poses, stance.weight});
      most_weight = std::max(most_weight, stance.weight);
    }
  }
  for (IncomingShape& in : all) in.weight /= most_weight;
  return all;
}

std::vector<IncomingShape> shapes_for_window(const Box& box, const std::vector<IncomingShape>& incoming,
                                             const std::vector<FormerPiece>& not_back, const Period& period,
                                             const ShapeSource& shapes) {
  const Vec2 middle = (box.low + box.high) * 0.5f;
  std::set<ShapeId> lay_there;
  for (const FormerPiece& piece : not_back) {
    const Vec2 at = period.nearest(piece.canvas_from_shape.translation(), middle);
    if (within_reach(box, {at, at}, 0.5f * piece.canvas_from_shape.scale()))
      lay_there.insert(shapes.silhouette(piece.shape));
  }
  std::vector<IncomingShape> let_in;
  for (const IncomingShape& in : incoming) {
    if (!lay_there.contains(in.drawing)) let_in.push_back(in);
  }
  return 2 * let_in.size() < incoming.size() ? incoming : let_in;
}

}  // namespace tessera
