// From the dockings that the early reject left to those that are compared over the whole library.
#pragma once

#include <vector>

#include "core/matching/docking.h"

namespace tessera::worker {

/// `dockings`: of one target sample. Keeps, best first (docks_better), at most kDockingsPerShape from pairs of each shape
/// and kShortlist in all.
void keep_docked_shortlist(std::vector<Docking>& dockings);

}  // namespace tessera::worker
