// A candidate is a docking that was refined, found feasible and scored. The best one becomes a placement (paper,
// section 4).
#pragma once

#include <cstdint>

#include "core/geometry/grid.h"
#include "core/geometry/similarity.h"
#include "core/matching/docking_terms.h"
#include "core/shape/shape_id.h"

namespace tessera {

struct Candidate {
  ShapeId shape{};
  std::uint32_t source = 0;
  std::uint32_t stance = 0;  // index in the matching context's StanceTable
  Similarity canvas_from_shape;
  DockingTerms terms;
  float score = 0;  // objective, estimated along the contour; exact once `exact` is set
  bool exact = false;
  Window window;        // nodes whose change changes the score
  float perimeter = 0;  // the shape's
  float radius = 0;
  std::uint32_t ordinal = 0;  // set by the pool: number among the candidates of its target sample
  std::uint64_t stamp = 0;    // set by the pool: identifies its latest ranking
};

}  // namespace tessera
