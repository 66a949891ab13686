// The shapes from which the random dockings of one question are drawn. In a very large library these are a few runs of
// neighbouring shapes, so that their data can be read at once. The deck follows from the seed, the samples of the
// question and the number of open shapes. So every rank computes the same deck, and each question has another one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/field/target_sample.h"

namespace tessera {

struct Deck {
  /// Places among the open shapes, ascending; empty: all open shapes.
  std::vector<std::uint32_t> open;
  /// Places in each list of shapes of similar colour (NearColours), ascending; empty: the whole list.
  std::vector<std::uint32_t> near;
};

/// `open_shapes`: number of shapes that may stand. `near_length`: length of each list of NearColours; 0 if there are no
/// lists.
Deck draw_deck(std::uint64_t seed, std::span<const TargetSample> samples, std::uint32_t library_shapes,
               std::uint32_t open_shapes, std::uint32_t near_length);

}  // namespace tessera
