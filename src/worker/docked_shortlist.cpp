#include "worker/docked_shortlist.h"

#include <algorithm>

#include "core/settings/tuning.h"

namespace tessera::worker {

void keep_docked_shortlist(std::vector<Docking>& dockings) {
  std::sort(dockings.begin(), dockings.end(), docks_better);
  std::vector<Docking> kept;
  for (const Docking& docking : dockings) {
    const auto of_its_pairs = [&](const Docking& d) { return d.shape == docking.shape && d.source < kTangentSource; };
    if (docking.source < kTangentSource && std::count_if(kept.begin(), kept.end(), of_its_pairs) == kDockingsPerShape) {
      continue;
    }
    kept.push_back(docking);
    if (kept.size() == std::size_t(kShortlist)) break;
  }
  dockings = std::move(kept);
}

}  // namespace tessera::worker
