// A candidate is a docking that a piece may get at a target sample; the best one becomes a placement (paper, section 4).
#pragma once

#include <cstdint>

#include "core/geometry/grid.h"
#include "core/geometry/similarity.h"
#include "core/matching/docking_terms.h"
#include "core/shape/shape_id.h"

namespace tessera {

/// A docking that was refined, found feasible and scored.
struct Candidate {
  ShapeId shape{};
  std::uint32_t source = 0;
  std::uint32_t stance = 0;  // of the matching context's
  Similarity canvas_from_shape;
  DockingTerms terms;
  float score = 0;  // objective along the contour; exact once `exact` is set
  bool exact = false;
  Window window;        // nodes whose change changes the score
  float perimeter = 0;  // the shape's
  float radius = 0;
  std::uint32_t ordinal = 0;  // among those of its target sample when they were put: the pool's
  std::uint64_t stamp = 0;    // of its latest ranking: the pool's
};

}  // namespace tessera
