#include "program/run_main.h"

#include <malloc.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <string>

#include "comm/in_process_communicator.h"
#include "comm/launcher_check.h"
#include "comm/mpi_job.h"
#include "comm/rank_program.h"
#include "comm/stop_signals.h"
#include "core/base/error.h"
#include "core/base/kept_memory.h"
#include "files/lack_of_memory.h"
#include "files/leftover_file.h"
#include "files/library_abort.h"
#include "run/progress/time_limit.h"
#include "terminal/exit_codes.h"
#include "terminal/terminal.h"

namespace tessera {
namespace {

/// The parsed command. Where the command line has a mistake: a command that reports it when it runs.
Command command_or_failure(const std::function<Command()>& parse) {
  try {
    return parse();
  } catch (...) {
    return {.run = [problem = std::current_exception()]() -> int { std::rethrow_exception(problem); }};
  }
}

int run_command(const Command& command, comm::Communicator& ranks) {
  if (!command.run_on_all_ranks) return ranks.rank() == 0 ? command.run() : 0;
  const std::string problem = comm::launcher_problem([](const char* name) { return std::getenv(name); }, ranks.size());
  if (!problem.empty()) throw InputError(problem);
  return command.run_on_all_ranks(ranks);
}

/// Whether Open MPI's mpirun or srun --mpi=pmix started this process. Otherwise MPI is not started: that takes a third
/// of a second.
bool started_by_launcher() { return std::getenv("OMPI_COMM_WORLD_SIZE") || std::getenv("PMIX_RANK"); }

/// Vectors of some MB come and go in every round, and of some dozen while a library is loaded. Given back to the system
/// in between, their pages are cleared each time: loading takes a third less without (docs/decisions/2026-11-25-models-in-the-library-file.md).
void keep_freed_memory() {
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the largest value allowed
  mallopt(M_TRIM_THRESHOLD, int(kKeptFreed_bytes));
}

/// The exit code of a finished command. Where a part of its output was lost, the command has failed; an interrupted
/// command keeps its exit code, as it must be called again anyway.
int printed_exit_code(int exit_code) {
  try {
    check_printed();
  } catch (const EnvironmentError& error) {
    if (exit_code != kUnfinishedExitCode) throw;
    print_message(error.what());
  }
  return exit_code;
}

/// Makes writing to a closed stdout or stderr an error instead of the end of the process: the work goes on.
void ignore_closed_pipes() { std::signal(SIGPIPE, SIG_IGN); }

/// Time for which the ranks of a job wait for each other at the start: as long as the time limit, at least 10 s. Four
/// ranks on a busy machine take some seconds.
comm::MpiPatience patience_of(const Command& command) {
  constexpr double kLeastStart_s = 10;
  comm::MpiPatience patience;
  try {
    const double limit_s =
        time_limit_s(command.time_limit, std::getenv("SLURM_JOB_END_TIME"), double(std::time(nullptr)), 0);
    patience.start_s = std::clamp(limit_s, kLeastStart_s, patience.start_s);
  } catch (const InputError&) {  // the command reports what is wrong with the limit
  }
  return patience;
}

int run(int argc, char** argv, const std::function<Command()>& parse) {
  occupy_standard_descriptors();
  ignore_closed_pipes();
  keep_freed_memory();
  comm::end_at_once_when_signalled(remove_leftover_files);
  std::signal(SIGXFSZ, SIG_IGN);  // a file at its size limit is an error of its writer, which then cleans up
  std::signal(SIGCHLD, SIG_DFL);  // the parent may have ignored it: then nobody learns how a child ended
  const Command command = command_or_failure(parse);
  const comm::RankProgram program{
      .run =
          [&](comm::Communicator& ranks) {
            return with_lack_of_memory_named([&] { return printed_exit_code(run_command(command, ranks)); });
          },
      .report_error = print_message};
  if (started_by_launcher()) return comm::run_mpi_job(argc, argv, program, patience_of(command));
  const LibraryAbortHandler end;  // reports where a library aborts; Open MPI has a handler of its own
  comm::InProcessNetwork alone(1);
  return comm::run_rank(*alone.connect(0), program).exit_code;
}

}  // namespace

int run_main(int argc, char** argv, const std::function<Command()>& parse) {
  const int exit_code = run(argc, argv, parse);
  if (exit_code != kUnfinishedExitCode) return exit_code;
  // A thread of PoCL may still compile for a request that was given up. It would crash while LLVM is torn down.
  std::fflush(nullptr);
  std::_Exit(exit_code);
}

}  // namespace tessera
