// The dockings of all target samples of a collage, and where refinement moved them.
#pragma once

#include <cstddef>
#include <vector>

#include "bench/concepts/collage_stage.h"

namespace tessera::bench::concepts {

struct DockedRound {
  std::vector<TargetSample> samples;
  std::vector<Docking> docked;          // by sample, best first
  std::vector<RefinedDocking> refined;  // in the order of docked
};

DockedRound docked_round(CollageStage& stage, const TracedTarget& target);

/// Whether a pair of PADs implied the docking: the other ones are random.
inline bool is_of_pads(const Docking& docking) { return docking.source < kTangentSource; }

/// The PAD of a shape that a docking came from.
struct DockedPad {
  std::size_t level = 0;   // index into kSmoothingLevels
  std::size_t sample = 0;  // of that level
};
DockedPad docked_pad(const MatchingContext& context, const Docking& docking);

}  // namespace tessera::bench::concepts
