// The shortest strip: exploring, that is shrinking it and separating the pieces, and compressing what came of it.
// After Gardeyn and Wauters (separation.h), Algorithms "explore" and "compress".
#pragma once

#include <functional>
#include <span>

#include "products/nesting/layout/nest_random.h"
#include "products/nesting/layout/nest_scene.h"

namespace tessera {

/// Puts pieces of these items one after the other, the largest first, each as far left as is found. They do not overlap;
/// the strip is as long as they reach. `laid`, if any, is told after each piece which items still have none.
void lay_in_order(NestScene& scene, std::vector<int> items, NestRandom& random,
                  const std::function<void(std::span<const int> left)>& laid = {});

/// Makes the strip as short as the budget allows. The scene's pieces do not overlap, before and after. `shorter`, if any,
/// is told each new length.
void shorten(NestScene& scene, std::uint64_t most_work, NestRandom& random,
             const std::function<void(double length)>& shorter);

}  // namespace tessera
