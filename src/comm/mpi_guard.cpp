#include "comm/mpi_guard.h"

#include <boost/mpi/config.hpp>  // mpi.h without its old C++ interface
#include <boost/mpi/exception.hpp>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "comm/mpi_communicator.h"
#include "comm/stop_signals.h"

namespace tessera::comm {

MpiGuard::MpiGuard(int& argc, char**& argv) : exceptions_before_(std::uncaught_exceptions()) {
  int provided = 0;
  BOOST_MPI_CHECK_RESULT(MPI_Init_thread, (&argc, &argv, MPI_THREAD_SERIALIZED, &provided));
  if (provided < MPI_THREAD_SERIALIZED) {  // heartbeats come from a thread of their own
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

[[noreturn]] void leave_at_once(int exit_code) {
  std::fflush(nullptr);
  std::_Exit(exit_code);
}

}  // namespace

int run_mpi_job(int& argc, char**& argv, const RankProgram& program) {
  const MpiGuard mpi(argc, argv);
  MpiCommunicator ranks;
  prepare_stop_signals(ranks.rank());
  try {
    const RankResult result = run_rank(ranks, program);
    if (result.ending == Ending::at_once) leave_at_once(result.exit_code);
    return result.exit_code;
  } catch (...) {  // the transport itself failed: nobody can be told
    program.report_error(ranks.place() + ": " + describe_current_exception().text);
    throw;
  }
}

}  // namespace tessera::comm
