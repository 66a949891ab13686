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

}  // namespace tessera::bench::concepts
