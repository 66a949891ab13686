// The signals that end a run before its time: Ctrl-C, the SIGTERM that mpirun and Slurm send, SIGUSR2, which Slurm
// sends on demand some time before the end, SIGHUP of a terminal that is gone, and SIGXCPU, the limit on processor
// time. A command that has nothing to save is ended by them at once. A run that has lets them set a flag; who asks for
// it ends with a checkpoint and what is done so far.
//
// What mpirun (Open MPI 4.1) does when it gets SIGINT (Ctrl-C), SIGTERM or SIGHUP, or when a
// rank died, to every rank: SIGCONT at once, SIGTERM after 1 s, SIGKILL after 2 s; each pause (MCA parameter
// odls_base_sigkill_timeout) ends early when a rank exits. Ctrl-C does not reach the ranks: each has a process group of
// its own. Meanwhile mpirun answers nobody: MPI_Finalize and MPI_Abort hang. A second Ctrl-C ends mpirun, and about a
// second later the ranks. mpirun's exit code is then 1.
//
// Hence: the SIGCONT counts as the stop signal; the workers stay until rank 0 has written its files; then all leave
// without MPI_Finalize.
#pragma once

#include <memory>

#include "core/base/stop.h"

namespace tessera::comm {

/// To be called once on each rank. Rank 0: mpirun's SIGCONT raises SIGTERM, and mpirun's own SIGTERM follows a second
/// later. Other ranks: the first SIGINT, SIGTERM and SIGHUP do nothing, and SIGUSR2, which mpirun and srun pass on to
/// all ranks, never does: rank 0 ends the job.
void prepare_stop_signals(int rank);

/// Whether mpirun has begun to kill the job.
bool launcher_ends_job();

/// From now on the signals above end the process at once, whatever it computes, with a line on stderr; before, they
/// call `clean_up`, which may do only what a signal handler may. A signal that is ignored stays so. For main; what
/// follows has an effect on the same signals.
void end_at_once_when_signalled(void (*clean_up)());

/// From now on the signals above only set a flag, however often they come (mpirun sends several); a SIGHUP
/// that is ignored stays so, as nohup asks for. To be called where a run has something to lose; before, they end the
/// process.
void install_stop_handlers();

/// Whether a signal has come since.
bool stop_signalled();
/// StopReason::signal where one has.
std::optional<StopReason> asked_by_signal();

/// Since the first of them; 0 where none has come.
double seconds_since_stop();

/// Whether another one has come a second or more after the first: somebody does not want to wait. What mpirun and Slurm
/// send is one stop, however many signals it is.
bool stop_signalled_again();

/// After install_stop_handlers, where nothing is left to lose: signals end the process at once again, also one that has
/// come.
void end_stop_handlers();

/// For files that are written one after the other and belong together: while it lives signals only set the flag, which
/// the writer may heed. At its end what held before holds again, also for a signal that came meanwhile.
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
