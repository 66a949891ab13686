// The same tests over threads and over MPI: on_all_ranks is linked from in_process_ranks.cpp or mpi_ranks.cpp.
#pragma once

#include <functional>

#include "comm/communicator.h"

namespace tessera::comm::test {

/// Runs `body` once on each rank of a job: over threads for jobs of 1, 2, 3, 4 and 12 ranks in turn (of 12, the
/// master asks only some itself), over MPI on the ranks
/// that mpirun started. A failed expectation on any rank ends the job's other ranks too.
void on_all_ranks(const std::function<void(Communicator&)>& body);

}  // namespace tessera::comm::test
