// Candidates for a hole: shapes docked to its rim, as large as there is room, then moved and grown in it.
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
  std::size_t incoming = 0;  // place among those given
  Similarity canvas_from_shape;
  float score_px2 = 0;  // its worth, less what it costs that others are in its way
};

/// A shape that may come in, and what an area of 1 is worth.
struct HoleGuest {
  const HoleShape* shape = nullptr;
  PoseRange poses;
  float weight = 1;
  float worth = 1;
};

/// The best few, distinct, best first; those that are worth nothing are left out. `softness`: what a px² that others are
/// in the way costs; neighbours will make some room.
std::vector<HoleCandidate> best_candidates(const Hole& hole, float reach_px, const std::vector<HoleGuest>& guests,
                                           float softness, Draws& draws, TaskPool& pool);

}  // namespace tessera
