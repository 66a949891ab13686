// The workers below a rank, and the rank itself, as one replacer (worker_tree.h). Who works on which window follows
// from the windows' trials and the workers' breadths; what comes of it does not.
#pragma once

#include <memory>

#include "comm/communicator.h"
#include "core/replacing/replacer.h"

namespace tessera::comm {

/// On rank 0, with at least one other rank: joins all workers of the job. Waits until every one has told its breadth
/// (serve). Throws the error that ended a worker. The communicator outlives the replacer.
std::unique_ptr<Replacer> gather_replacers(Communicator& ranks);

/// On a worker: joins its own cores and the workers below it; gives `own` alone where there are none.
std::unique_ptr<Replacer> gather_replacers(Communicator& ranks, std::unique_ptr<Replacer> own);

}  // namespace tessera::comm
