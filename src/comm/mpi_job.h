// Runs MPI from start to end, and a job on it.
#pragma once

#include "comm/rank_program.h"

namespace tessera::comm {

/// Initialises MPI for use by one thread at a time, and finalises it. Leaving by an exception ends all ranks instead:
/// the others may be waiting for this one, and finalising would wait for them. Without mpirun the job has one rank.
class MpiGuard {
 public:
  MpiGuard(int& argc, char**& argv);
  ~MpiGuard();
  MpiGuard(const MpiGuard&) = delete;
  MpiGuard& operator=(const MpiGuard&) = delete;

 private:
  int exceptions_before_;
};

/// How long ranks wait for each other where MPI itself waits.
struct MpiPatience {
  double start_s = 300;  // until all ranks are there: a large cluster takes a minute
  double end_s = 30;     // until all have left, once they have said goodbye
};

/// What main returns: runs `program` as this process' rank of the job and leaves together with the others, with the
/// signals as stop_signals.h says. mpirun's exit code is that of rank 0. Where some ranks do not start or end MPI in
/// time, as one was stopped, hangs or was never started, the others end with a message.
int run_mpi_job(int& argc, char**& argv, const RankProgram& program, const MpiPatience& patience = {});

}  // namespace tessera::comm
