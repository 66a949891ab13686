// The chains of a nesting shared among ranks and their cores. What comes out does not depend on how many there are.
#pragma once

#include <functional>

#include "comm/communicator.h"
#include "core/nesting/nesting.h"

namespace tessera::cli {

/// Rank 0: sends the problem to all ranks, and gives the best layout of all chains. `progress` as NestProgress, called
/// by one thread at a time. Throws Interrupted soon after `stop_reason`, which any thread may ask, gives a reason.
NestLayout best_nesting(comm::Communicator& ranks, const NestProblem& problem, const NestEffort& effort,
                        std::uint64_t seed, const NestProgress& progress,
                        const std::function<const char*()>& stop_reason);

/// Every other rank: takes its share of the chains. Leaves by JobEnded soon after rank 0 ended the job.
void work_on_nesting(comm::Communicator& ranks);

}  // namespace tessera::cli
