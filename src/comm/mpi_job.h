// Starts MPI, runs one rank of a job, and ends MPI.
#pragma once

#include "comm/rank_program.h"

namespace tessera::comm {

/// Initialises MPI for use by one thread at a time, and finalises it. Where it is destroyed by an exception it aborts
/// all ranks: others may be waiting for this rank, and finalising would wait for them. Without mpirun the job has one
/// rank.
class MpiGuard {
 public:
  MpiGuard(int& argc, char**& argv);
  ~MpiGuard();
  MpiGuard(const MpiGuard&) = delete;
  MpiGuard& operator=(const MpiGuard&) = delete;

 private:
  int exceptions_before_;
};

/// Time limits for ranks that wait for each other in MPI's own start and end.
struct MpiPatience {
  double start_s = 300;  // until all ranks have started: a large cluster takes a minute
  double end_s = 30;     // until all ranks have left, after they said goodbye
};

/// The body of main: runs `program` as this process' rank of the job and leaves together with the others; signals as in
/// stop_signals.h. Returns the exit code; mpirun's is that of rank 0. Where some ranks do not start or end MPI in time
/// (stopped, hanging, or never started), the others end with a message.
int run_mpi_job(int& argc, char**& argv, const RankProgram& program, const MpiPatience& patience = {});

}  // namespace tessera::comm
