// All workers of a job as one matcher.
#pragma once

#include <memory>
#include <vector>

#include "comm/communicator.h"
#include "core/matcher.h"
#include "core/rank_statistics.h"

namespace tessera::comm {

/// On rank 0, with at least one other rank: waits until every worker has told its shapes (serve), which takes as long
/// as the slowest one's start. Throws what a worker failed of. The communicator outlives the matcher.
std::unique_ptr<Matcher> gather_workers(Communicator& ranks);

/// On rank 0, when the workers have answered everything: how each spent its time since the field was started.
std::vector<WorkerTimes> gather_times(Communicator& ranks);

}  // namespace tessera::comm
