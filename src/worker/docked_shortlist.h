// Chooses the dockings that are compared over the whole library, from the dockings that passed the early reject.
#pragma once

#include <vector>

#include "core/matching/docking.h"

namespace tessera::worker {

/// Keeps the best dockings of one target sample, best first (docks_better): at most kDockingsPerShape from pairs of each
/// shape, and kShortlist in all.
void keep_docked_shortlist(std::vector<Docking>& dockings);

}  // namespace tessera::worker
