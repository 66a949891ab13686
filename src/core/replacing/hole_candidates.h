// Candidates for a hole: shapes docked to its rim at the size that there is room for, then moved and grown in the hole.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/task_pool.h"
#include "core/replacing/draws.h"
#include "core/replacing/hole.h"
#include "core/replacing/hole_shape.h"
#include "core/replacing/replacement.h"

namespace tessera {

struct HoleCandidate {
  std::size_t incoming = 0;  // index in the list of guests
  Similarity canvas_from_shape;
  float score_px2 = 0;  // worth of its area, less the cost of its overlaps
};

/// A shape that may come in, and the worth of an area of 1.
struct CandidateShape {
  const HoleShape* shape = nullptr;
  PoseRange poses;
  float weight = 1;
  float worth = 1;
};

/// The best few distinct candidates with a positive score, best first. `softness`: cost of a px² of overlap with
/// neighbours; it may be low as neighbours will make some room.
std::vector<HoleCandidate> best_candidates(const Hole& hole, float reach_px, const std::vector<CandidateShape>& guests,
                                           float softness, Draws& draws, TaskPool& pool);

}  // namespace tessera
