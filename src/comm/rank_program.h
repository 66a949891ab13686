// What one rank of a job runs, and how all of them end together, whatever happens:
//   rank 0 returns or throws   its exit code is the job's; an error is reported once, by rank 0; all others are told to
//                              leave, which they do at their next wait (JobEnded)
//   another rank throws        it tells rank 0 what and where, and waits to be told to leave; rank 0's next wait throws
//                              the same InputError or EnvironmentError with the rank's name before the text
// A rank that dies without a word is mpirun's to notice: it ends the job. One that hangs is rank 0's to notice
// (rank_watch.h); it cannot say goodbye, so that rank 0 aborts the job with its exit code.
#pragma once

#include <functional>
#include <string>

#include "comm/communicator.h"

namespace tessera::comm {

struct RankProgram {
  /// Runs on every rank and returns the exit code; only that of rank 0 counts. Ranks other than 0 may throw JobEnded.
  std::function<int(Communicator&)> run;
  /// Rank 0: shows the user one line.
  std::function<void(const std::string& line)> report_error;
};

struct RankResult {
  int exit_code = 0;  // of this process; 0 on all ranks but 0
  Ending ending = Ending::orderly;
};

RankResult run_rank(Communicator& ranks, const RankProgram& program);

}  // namespace tessera::comm
