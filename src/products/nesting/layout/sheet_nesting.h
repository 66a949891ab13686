// Fills as few sheets as possible, one after the other, the largest pieces first.
#pragma once

#include <vector>

#include "products/nesting/layout/nest_random.h"
#include "products/nesting/layout/nest_scene.h"

namespace tessera {

/// Puts as many of the pieces, given by their items, on the sheet as it can, and returns the others. Pieces on the sheet
/// move to make room.
std::vector<int> fill_sheet(NestScene& scene, std::vector<int> items, std::uint64_t most_work, NestRandom& random);

}  // namespace tessera
