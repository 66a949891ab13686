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

/// What main returns: runs `program` as this process' rank of the job and leaves together with the others, with the
/// signals as stop_signals.h says. mpirun's exit code is that of rank 0.
int run_mpi_job(int& argc, char**& argv, const RankProgram& program);

}  // namespace tessera::comm
