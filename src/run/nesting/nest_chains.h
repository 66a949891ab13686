// The chains of a nesting shared among ranks and their cores. What comes out does not depend on how many there are,
// unless the search is stopped.
#pragma once

#include <functional>

#include "comm/communicator.h"
#include "core/base/stop.h"
#include "products/nesting/layout/nesting.h"

namespace tessera {

struct NestOutcome {
  NestLayout layout;                     // the best; without a piece where none fits
  std::optional<StopReason> stopped_by;  // nothing: all chains ended by themselves
};

/// Told now and then, by one thread at a time: the part of the budget that this rank's chains have used, 0 to 1, and
/// the best layout that they have found so far.
using NestProgress = std::function<void(double done, const NestLayout& best)>;

/// Rank 0: sends the problem to all ranks, and gives the best layout of all chains. Soon after `shall_stop`, which any
/// thread may ask, gives a reason, or where `ranks` finds one of them lost (watch_workers), it gives the best of what
/// all ranks have told it; nobody is waited for.
NestOutcome best_nesting(comm::Communicator& ranks, const NestProblem& problem, const NestEffort& effort,
                         std::uint64_t seed, const NestProgress& progress, const StopQuestion& shall_stop);

/// Every other rank: takes its share of the chains. Rank 0 may hold it for lost after `silence_s` without a heartbeat.
/// Leaves by JobEnded soon after rank 0 ended the job. Throws EnvironmentError where rank 0 runs another program.
[[noreturn]] void work_on_nesting(comm::Communicator& ranks, double silence_s);

}  // namespace tessera
