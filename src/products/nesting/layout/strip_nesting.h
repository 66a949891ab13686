// Finds a short strip in two phases: exploring (shrinking the strip and separating the pieces), and compressing the result.
// After Gardeyn and Wauters (separation.h), Algorithms "explore" and "compress".
#pragma once

#include <functional>
#include <span>

#include "products/nesting/layout/nest_random.h"
#include "products/nesting/layout/nest_scene.h"

namespace tessera {

/// Places pieces of these items one after the other, the largest first, each as far left as it finds. They do not overlap;
/// the strip ends where they end. `laid` is called after each piece with the items that are still to be placed.
void lay_in_order(NestScene& scene, std::vector<int> items, NestRandom& random,
                  const std::function<void(std::span<const int> left)>& laid = {});

/// Makes the strip as short as the budget allows. The scene's pieces do not overlap, before and after. `shorter` is called
/// with each new length.
void shorten(NestScene& scene, std::uint64_t most_work, NestRandom& random,
             const std::function<void(double length)>& shorter);

}  // namespace tessera
