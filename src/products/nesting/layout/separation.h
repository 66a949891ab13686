// Separates overlapping pieces: guided local search, after Gardeyn and Wauters, "An open-source heuristic to reboot 2D
// nesting research" (sparrow, 2025), Algorithm "separate".
#pragma once

#include "products/nesting/layout/nest_random.h"
#include "products/nesting/layout/nest_scene.h"

namespace tessera {

struct SeparationLimits {
  int patience = 0;             // passes without less overlap
  int strikes = 0;              // how often this may happen without any gain
  std::uint64_t most_work = 0;  // NestScene::work at which it ends
};

/// True where nothing overlaps any more. Otherwise the scene has the least overlap that was seen.
bool separate(NestScene& scene, const SeparationLimits& limits, NestRandom& random);

}  // namespace tessera
