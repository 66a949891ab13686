#include "comm/mpi_job.h"

#include <boost/mpi/config.hpp>  // mpi.h without its old C++ interface
#include <boost/mpi/exception.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>
#include <string>

#include "comm/mpi_communicator.h"
#include "comm/refused_copies.h"
#include "comm/stop_signals.h"
#include "comm/watchdog.h"

namespace tessera::comm {

MpiGuard::MpiGuard(int& argc, char**& argv) : exceptions_before_(std::uncaught_exceptions()) {
  int provided = 0;
  BOOST_MPI_CHECK_RESULT(MPI_Init_thread, (&argc, &argv, MPI_THREAD_SERIALIZED, &provided));
  if (provided < MPI_THREAD_SERIALIZED) {  // heartbeats are sent from another thread
    std::fprintf(stderr, "tessera: this MPI library serves a single thread; needed: MPI_THREAD_SERIALIZED\n");
    MPI_Abort(MPI_COMM_WORLD, kEnvironmentExitCode);
  }
  BOOST_MPI_CHECK_RESULT(MPI_Comm_set_errhandler, (MPI_COMM_WORLD, MPI_ERRORS_RETURN));
}

MpiGuard::~MpiGuard() {
  if (std::uncaught_exceptions() > exceptions_before_) MPI_Abort(MPI_COMM_WORLD, kEnvironmentExitCode);
  MPI_Finalize();
}

namespace {

/// Delay of the other ranks' messages. Rank 0 reports first, then rank 1, then all others: once one has reported and
/// left, the launcher ends the rest.
constexpr double kBehind_s = 5;

[[noreturn]] void leave_at_once(int exit_code) {
  std::fflush(nullptr);
  std::_Exit(exit_code);
}

/// The rank that the launcher's environment states, for the time before MPI can be asked.
std::string launched_rank() {
  for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK"}) {
    if (const char* rank = std::getenv(name)) return rank;
  }
  return "0";
}

/// Ends this process with `exit_code` and a message unless the MPI calls that `doing` names end in time. `rest`: the
/// end of the message, which says what became of the run.
void watch(std::optional<Watchdog>& watchdog, const RankProgram& program, double patience_s, int exit_code,
           const std::string& doing, const std::string& rest) {
  const std::string rank = launched_rank();
  const double own_patience_s = patience_s + (rank == "0" ? 0 : rank == "1" ? 1 : 2) * kBehind_s;
  start_if_possible(watchdog, own_patience_s, exit_code, [=, report = program.report_error] {
    report("rank " + rank + " has waited " + std::to_string(std::lround(own_patience_s)) +
           " s for the other ranks to " + doing + ": one of them was stopped, hangs or was never started; " + rest);
  });
}

}  // namespace

int run_mpi_job(int& argc, char**& argv, const RankProgram& program, const MpiPatience& patience) {
  do_without_refused_copies();
  std::optional<Watchdog> leaving;  // must outlive MPI
  std::optional<Watchdog> starting;
  watch(starting, program, patience.start_s, kEnvironmentExitCode, "start MPI",
        "the run ends before it has begun: start it again");
  const MpiGuard mpi(argc, argv);
  MpiCommunicator ranks;
  starting.reset();
  prepare_stop_signals(ranks.rank());
  try {
    const RankResult result = run_rank(ranks, program);
    if (result.ending == Ending::at_once) leave_at_once(result.exit_code);
    watch(leaving, program, patience.end_s, result.exit_code, "end MPI", "the run's files are written");
    return result.exit_code;
  } catch (...) {  // the transport itself failed: no rank can be told
    program.report_error(ranks.place() + ": " + describe_current_exception().text);
    watch(leaving, program, patience.end_s, kEnvironmentExitCode, "end MPI", "the run ends here");
    throw;
  }
}

}  // namespace tessera::comm
