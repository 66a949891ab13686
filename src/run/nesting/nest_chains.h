// Shares the chains of a nesting among ranks and their cores. The outcome does not depend on their number, unless the
// search is stopped.
#pragma once

#include <functional>

#include "comm/communicator.h"
#include "core/base/stop.h"
#include "products/nesting/layout/nesting.h"

namespace tessera {

struct NestOutcome {
  NestLayout layout;                     // the best layout; without pieces where none fits
  std::optional<StopReason> stopped_by;  // empty: all chains ended by themselves
};

/// Called regularly, by one thread at a time, with the part of the budget (0 to 1) that this rank's chains have used and
/// the best layout that they have found.
using NestProgress = std::function<void(double done, const NestLayout& best)>;

/// Called by rank 0: sends the problem to all ranks and returns the best layout of all chains. Any thread may call `shall_stop`.
/// Soon after it gives a reason, or after `ranks` finds a rank lost (watch_workers), returns the best layout that all ranks
/// have reported; it waits for nobody.
NestOutcome best_nesting(comm::Communicator& ranks, const NestProblem& problem, const NestEffort& effort,
                         std::uint64_t seed, const NestProgress& progress, const StopQuestion& shall_stop);

/// Called by every other rank: computes its share of the chains. Rank 0 may take it for lost after `silence_s` seconds without a
/// heartbeat. Leaves by JobEnded soon after rank 0 ended the job. Throws EnvironmentError where rank 0 runs another
/// program.
[[noreturn]] void work_on_nesting(comm::Communicator& ranks, double silence_s);

}  // namespace tessera
