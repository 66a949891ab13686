// The signals that end a run early: Ctrl-C; the SIGTERM of mpirun and Slurm; SIGUSR2, which Slurm sends on demand some
// time before the end; SIGHUP of a closed terminal; SIGXCPU, the limit on processor time. They end a command that has
// nothing to save at once. In a run that has something to save they set a flag; the run polls it and ends with a
// checkpoint and its results so far.
//
// mpirun (Open MPI 4.1), when it gets SIGINT (Ctrl-C), SIGTERM or SIGHUP or when a rank died, sends to every rank:
// SIGCONT at once, SIGTERM after 1 s, SIGKILL after 2 s. Each pause (MCA parameter odls_base_sigkill_timeout) ends
// early when a rank exits. Ctrl-C does not reach the ranks: each has a process group of its own. Meanwhile MPI_Finalize
// and MPI_Abort hang, as mpirun does not answer. A second Ctrl-C ends mpirun, and about a second later the ranks.
// mpirun's exit code is then 1.
//
// Therefore SIGCONT counts as the stop signal; the workers stay until rank 0 has written its files; then all ranks
// leave without MPI_Finalize.
#pragma once

#include <memory>

#include "core/base/stop.h"

namespace tessera::comm {

/// Prepares the signals that mpirun sends; to be called once on each rank. On rank 0 mpirun's SIGCONT raises SIGTERM;
/// mpirun's own SIGTERM follows a second later. On other ranks the first SIGINT, SIGTERM and SIGHUP do nothing, and
/// SIGUSR2, which mpirun and srun pass on to all ranks, never does anything: rank 0 ends the job.
void prepare_stop_signals(int rank);

/// Whether mpirun has begun to kill the job.
bool launcher_ends_job();

/// Makes the signals above end the process at once, with a line on stderr. Before that they call `clean_up`, which may
/// only do what a signal handler may. Signals that are ignored stay ignored. For main; the functions below change the
/// handling of the same signals.
void end_at_once_when_signalled(void (*clean_up)());

/// Makes the signals above only set a flag, however often they come (mpirun sends several). An ignored SIGHUP stays
/// ignored, as nohup asks for. To be called once a run has something to lose; before, signals end the process.
void install_stop_handlers();

/// Whether a signal has come since install_stop_handlers().
bool stop_signalled();
/// StopReason::signal where a signal has come.
std::optional<StopReason> stop_asked_by_signal();

/// Seconds since the first signal; 0 where none has come.
double seconds_since_stop();

/// Whether another signal came a second or more after the first: the user does not want to wait. All signals that
/// mpirun and Slurm send for one stop count as one.
bool stop_signalled_again();

/// Makes signals end the process at once again, also a signal that has already come. To be called after
/// install_stop_handlers(), once nothing is left to lose.
void end_stop_handlers();

/// While it lives, signals only set the flag, which the caller may poll: for files that are written one after the other
/// and belong together. Its end restores the handling from before and raises a signal that came meanwhile.
class StopDelay {
 public:
  StopDelay();
  ~StopDelay();
  StopDelay(const StopDelay&) = delete;
  StopDelay& operator=(const StopDelay&) = delete;

 private:
  struct Before;
  std::unique_ptr<Before> before_;
};

}  // namespace tessera::comm
