// The workers below a rank as one matcher (worker_tree.h).
#pragma once

#include <memory>
#include <vector>

#include "comm/communicator.h"
#include "core/matching/matcher.h"
#include "core/ranks/rank_statistics.h"

namespace tessera::comm {

/// Joins all workers of the job; for rank 0 with at least one other rank. Waits until each has told its shapes (serve),
/// which takes as long as the slowest start. Throws the error that ended a worker. The communicator must outlive the
/// matcher.
std::unique_ptr<Matcher> gather_workers(Communicator& ranks);

/// Joins a worker's own part and those of the workers below it; returns only `own` where there are none below.
std::unique_ptr<Matcher> gather_workers(Communicator& ranks, std::unique_ptr<Matcher> own);

/// The times of each worker below this rank in the loop, in the order of the ranks. A worker's loop begins with the
/// first field after its times were last asked for. To be called when the workers have answered everything.
std::vector<WorkerTimes> gather_times(Communicator& ranks);

}  // namespace tessera::comm
