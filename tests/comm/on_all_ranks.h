// Runs the same tests over threads and over MPI. on_all_ranks is linked from in_process_ranks.cpp or mpi_ranks.cpp.
#pragma once

#include <functional>

#include "comm/communicator.h"

namespace tessera::comm::test {

/// Runs `body` once on each rank of a job. Over threads it does so for jobs of 1, 2, 3, 4 and 12 ranks in turn; with 12 the master asks
/// only some workers itself. Over MPI it uses the ranks that mpirun started.
/// A failed expectation on any rank also ends the job on the other ranks.
void on_all_ranks(const std::function<void(Communicator&)>& body);

}  // namespace tessera::comm::test
