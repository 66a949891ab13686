// Which shapes the random dockings of a question draw from: of a very large library some that lie in runs, so that what
// is needed of them is read at once. They follow from the question and what it is asked of (the seed, how many shapes may
// stand), so that every rank knows them, and each question has others.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/field/target_sample.h"

namespace tessera {

struct Deck {
  /// Places among the shapes that may stand, ascending; empty: all of them.
  std::vector<std::uint32_t> open;
  /// Places in each list of shapes of about one colour (NearColours), ascending; empty: all of them.
  std::vector<std::uint32_t> near;
};

/// `open_shapes`: how many may stand; `near_length`: of a list, 0 where there are none.
Deck draw_deck(std::uint64_t seed, std::span<const TargetSample> samples, std::uint32_t library_shapes,
               std::uint32_t open_shapes, std::uint32_t near_length);

}  // namespace tessera
