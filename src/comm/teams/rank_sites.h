// The machine and devices of each rank, sent to rank 0 once for its records.
#pragma once

#include <vector>

#include "comm/communicator.h"
#include "core/ranks/rank_site.h"

namespace tessera::comm {

/// Sends `site` to rank 0 without waiting. To be called once on every rank except 0.
void tell_site(Communicator& ranks, const RankSite& site);

/// Returns `own`, then the sites of ranks 1, 2, ...; for rank 0. Waits for all of them; throws the error that ended a
/// rank.
std::vector<RankSite> gather_sites(Communicator& ranks, RankSite own);

}  // namespace tessera::comm
