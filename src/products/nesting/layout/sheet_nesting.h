// As few sheets as are needed: each is filled as well as is found, the largest pieces first.
#pragma once

#include <vector>

#include "products/nesting/layout/nest_random.h"
#include "products/nesting/layout/nest_scene.h"

namespace tessera {

/// Puts as many of the pieces, given by their items, on the sheet as are found to fit, and returns the others. What is
/// put in makes the others move.
std::vector<int> fill_sheet(NestScene& scene, std::vector<int> items, std::uint64_t most_work, NestRandom& random);

}  // namespace tessera
