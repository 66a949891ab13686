// The program of one rank of a job, and the end of all its ranks, whatever happens:
//   rank 0 returns or throws   its exit code is the job's; an error is reported once, by rank 0; all others are told to
//                              leave, which they do at their next wait (JobEnded)
//   another rank throws        it tells rank 0 what and where, and waits to be told to leave; rank 0's next wait throws
//                              the same InputError or EnvironmentError with the rank's name before the text
// mpirun notices a rank that dies without a message, and ends the job. Rank 0 notices a rank that hangs (rank_watch.h).
// A rank that hangs cannot end its part of MPI properly. So rank 0 aborts the whole job, with its own exit code.
#pragma once

#include <functional>
#include <string>

#include "comm/communicator.h"

namespace tessera::comm {

struct RankProgram {
  /// Runs on every rank and returns the exit code; only that of rank 0 counts. Ranks other than 0 may throw JobEnded.
  std::function<int(Communicator&)> run;
  /// Shows the user one line; called on rank 0.
  std::function<void(const std::string& line)> report_error;
};

struct RankResult {
  int exit_code = 0;  // of this process; 0 on all ranks except 0
  Ending ending = Ending::orderly;
};

RankResult run_rank(Communicator& ranks, const RankProgram& program);

}  // namespace tessera::comm
