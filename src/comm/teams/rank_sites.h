// Which rank runs where and on which devices, told to rank 0 once for its records.
#pragma once

#include <vector>

#include "comm/communicator.h"
#include "core/ranks/rank_site.h"

namespace tessera::comm {

/// To be called once on every rank but 0. Waits for nobody.
void tell_site(Communicator& ranks, const RankSite& site);

/// On rank 0: gives `own`, then the sites of ranks 1, 2, ... Waits until all have told theirs; throws the error that
/// ended a rank.
std::vector<RankSite> gather_sites(Communicator& ranks, RankSite own);

}  // namespace tessera::comm
