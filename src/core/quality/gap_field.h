// Gaps between the pieces of a collage, as the discs that fit into the uncovered area.
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry/grid.h"
#include "core/geometry/period.h"
#include "core/geometry/vec2.h"
#include "core/quality/cell_counts.h"

namespace tessera {

/// The distances of the uncovered part of a canvas to what is covered or outside.
struct GapField {
  Grid<float> squared;  // squared distance, nodes²; 0 where nothing is free
  float node_px = 1;    // distance of two nodes
  Vec2 first_px;        // place of node (0, 0) on the canvas
  Period period;
};

GapField gap_field(const CellCounts& counts, const Period& period);

/// The radius of the largest disc that fits into the uncovered area; 0 where all is covered.
double largest_gap_px(const GapField& field);

struct GapDisc {
  Vec2 centre_px;
  float radius_px = 0;

  friend bool operator==(const GapDisc&, const GapDisc&) = default;
};

/// Discs in the uncovered area that do not overlap, of at least this radius: each is the largest that the earlier ones
/// leave room for, as far as a node is its centre. At most `most` of them. On a seamless canvas their centres lie in the
/// first period.
std::vector<GapDisc> gap_discs(const GapField& field, float least_radius_px, std::size_t most);

}  // namespace tessera
