#include "core/collage/exact_terms.h"

#include <bit>
#include <cmath>

#include "core/field/nodes_near.h"
#include "core/field/piece_distance.h"
#include "core/geometry/bit_grid.h"
#include "core/settings/tuning.h"

namespace tessera {
namespace {

constexpr int kRim = 2;  // nodes at the window's edge whose surroundings are cut off

/// The nodes of `a` that are not in `b`.
BitGrid without(BitGrid a, const BitGrid& b) {
  for (int y = 0; y < a.height(); ++y) {
    for (int k = 0; k < a.words(); ++k) a.row(y)[k] &= ~b.row(y)[k];
  }
  return a;
}

/// Calls f(x, y) for every set bit (node) of word k of row y.
template <class F>
void each_node(std::uint64_t word, int k, int y, F f) {
  for (; word != 0; word &= word - 1) f(64 * k + std::countr_zero(word), y);
}

/// The new sum of squares of parts when the sum of the parts changes from `before` to `after`.
float with_sum(float squares, float before, float after) {
  if (before <= 0) return after * after;
  const float ratio = after / before;
  return squares * (ratio * ratio);
}

}  // namespace

DockingTerms with_exact_areas(DockingTerms terms, const ExactAreas& areas) {
  terms.overlap_px4 = with_sum(terms.overlap_px4, terms.overlap_px2, areas.overlap_px2);
  terms.gap_px4 = with_sum(terms.gap_px4, terms.gap_px2, areas.gap_px2);
  terms.overlap_px2 = areas.overlap_px2;
  terms.gap_px2 = areas.gap_px2;
  return terms;
}

Window exact_window(const Shape& shape, const Similarity& canvas_from_shape, const FreeField& free,
                    const PieceSettings& pieces) {
  const CanvasField& field = free.field();
  return piece_window(shape.outline, canvas_from_shape, field.origin, 2 * reachable_radius_px(pieces) + 3)
      .intersected(field.value.bounds());
}

ExactAreas exact_areas(const Shape& shape, const Similarity& canvas_from_shape, const FreeField& free,
                       const OpenedField& opened, const PieceSettings& pieces) {
  const CanvasField& field = free.field();
  const float reach_px = reachable_radius_px(pieces);
  const Window window = exact_window(shape, canvas_from_shape, free, pieces);
  if (window.width() <= 2 * kRim || window.height() <= 2 * kRim) return {};

  const PieceDistance piece(shape, canvas_from_shape, kept_distance_px(pieces));
  const BitGrid inside_piece = nodes_nearer_than(0, piece, field.origin, window);
  const BitGrid centres = nodes_above(field.value, window, reach_px);
  const float up_to_reach_px = std::nextafter(reach_px, INFINITY);
  const BitGrid centres_after =
      without(centres, nodes_nearer_than(up_to_reach_px, piece, field.origin, window, centres));
  const float disc_px = reach_px + kReachSlack_px;
  const BitGrid within_reach = dilated_by_disc(centres_after, disc_px * disc_px);
  const BitGrid uncovered = nodes_above(field.value, window, 0);
  const Window counted = Window{0, 0, window.width(), window.height()}.grown(-kRim);
  int overlap = 0;
  int gap = 0;
  for (int y = 0; y < window.height(); ++y) {
    for (int k = 0; k < uncovered.words(); ++k) {
      const std::uint64_t inside = inside_piece.row(y)[k];
      const std::uint64_t free_here = uncovered.row(y)[k];
      each_node(inside & ~free_here, k, y,
                [&](int i, int j) { overlap += field.value(window.x0 + i, window.y0 + j) < -kOverlapDepth_px; });
      each_node(~inside & free_here & ~within_reach.row(y)[k], k, y,
                [&](int i, int j) { gap += counted.contains(i, j) && opened.reachable(window.x0 + i, window.y0 + j); });
    }
  }
  return {float(overlap), float(gap)};
}

}  // namespace tessera
