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

/// Level slot and index within the level of a source.
struct SourceLocation {
  int level_slot;
  int index;
};
SourceLocation locate_source(const ShapeModel& shape, std::uint32_t source);

}  // namespace tessera
