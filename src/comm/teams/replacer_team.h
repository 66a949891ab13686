// The workers below a rank, and the rank itself, as one replacer (worker_tree.h). The windows' trials and the workers'
// breadths decide who works on which window; the outcome does not depend on it.
#pragma once

#include <memory>

#include "comm/communicator.h"
#include "core/replacing/replacer.h"

namespace tessera::comm {

/// Joins all workers of the job; for rank 0 with at least one other rank. Waits until each has told its breadth
/// (serve). Throws the error that ended a worker. The communicator must outlive the replacer.
std::unique_ptr<Replacer> gather_replacers(Communicator& ranks);

/// Joins a worker's own cores and the workers below it; returns only `own` where there are none below.
std::unique_ptr<Replacer> gather_replacers(Communicator& ranks, std::unique_ptr<Replacer> own);

}  // namespace tessera::comm
