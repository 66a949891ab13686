// Selects the (target sample, shape PAD) pairs that are worth docking (paper section 3.3). The tests are, in this
// order: scale window, sign, local minima of the distance along the shape's curve, the best few of the shape.
// kernels/pairs.cl and worker/pair_choice do the same for many at once, bit for bit.
#pragma once

#include <vector>

#include "core/field/target_sample.h"
#include "core/matching/matching_context.h"
#include "core/shape/shape_model.h"

namespace tessera {

struct PadPair {
  std::uint32_t source = 0;    // index of the shape's PAD, counted over the levels in use
  std::uint32_t distance = 0;  // pad_steps
};

/// Returns at most kPairsPerShape pairs nearer than `reach_steps`, best first; ties go by source. `list`: the shape's
/// stances in the context's StanceTable.
std::vector<PadPair> select_pairs(const ShapeModel& shape, const TargetSample& sample, const StanceList& list,
                                  const MatchingContext& context, std::uint32_t reach_steps);

/// The place of a shape's PAD.
struct SourceLocation {
  int level_slot;  // index in the list of smoothing levels in use
  int index;       // of the sample within that level
};
/// `levels`: MatchingContext::levels. `source`: index of the PAD over all of them, less than their samples together.
SourceLocation locate_source(const std::vector<int>& levels, std::uint32_t source);

}  // namespace tessera
