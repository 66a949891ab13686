// The job of mpi_job_test.sh. Usage: mpi_job HOW FILE. Rank 0 writes FILE at its end.
#include <boost/mpi/config.hpp>  // has mpi.h leave out its old C++ interface
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>

#include "comm/mpi_job.h"
#include "core/base/error.h"
#include "core/base/stop.h"

namespace {

using tessera::comm::Communicator;
using tessera::comm::Tag;

volatile std::sig_atomic_t stopped = 0;

int lead(Communicator& ranks, const std::string& how, const std::string& file) {
  if (how == "rank_0_input_error") throw tessera::InputError("job.toml:3: bad key");
  if (how == "late_message") throw tessera::InputError("nothing to do");
  if (how == "rank_0_environment_error") throw tessera::EnvironmentError("disk full");
  if (how == "interrupted") {
    std::signal(SIGTERM, [](int) { stopped = 1; });
    ranks.interrupt_waits_when([] { return stopped ? std::optional(tessera::StopReason::signal) : std::nullopt; });
    std::printf("running\n");
    std::fflush(stdout);
  }
  try {
    if (how != "done" && !how.starts_with("stopped")) ranks.receive(1, Tag::turn);
  } catch (const tessera::Interrupted&) {
    std::this_thread::sleep_for(std::chrono::milliseconds(700));  // simulates the drawing of pictures
  }
  std::ofstream(file) << "written\n";
  return 0;
}

/// The master tells rank 1 to leave before rank 2's large message to it is through. That message needs rank 1's help.
int exchange(Communicator& ranks) {
  if (ranks.rank() == 1) ranks.receive(2, Tag::turn);
  std::this_thread::sleep_for(std::chrono::seconds(1));
  ranks.send(1, Tag::turn, tessera::comm::Bytes(1'000'000));
  return 0;
}

int work(Communicator& ranks, const std::string& how) {
  if (how == "late_message") return exchange(ranks);
  if (ranks.rank() == 1) {
    if (how == "worker_input_error") throw tessera::InputError("library.h5 is damaged");
    if (how == "worker_bug") throw std::logic_error("oops");
    if (how == "worker_dies") std::raise(SIGKILL);
  }
  // This rank is too busy to notice that the job is over.
  if (ranks.rank() == 2 && how == "interrupted") std::this_thread::sleep_for(std::chrono::seconds(20));
  ranks.receive(0, Tag::turn);
  return 0;
}

/// The patience with stopped ranks: short where `how` stops a rank.
tessera::comm::MpiPatience patience_of(const std::string& how) {
  tessera::comm::MpiPatience patience;
  if (how.starts_with("stopped_starting")) patience.start_s = 2;
  if (how.starts_with("stopped_ending")) patience.end_s = 2;
  return patience;
}

/// Stops this process at `where`, if `how` is "stopped_WHERE_RANK" with this rank.
void stop_if_told(const std::string& where) {
  const char* rank = std::getenv("OMPI_COMM_WORLD_RANK");
  const char* how = std::getenv("MPI_JOB_HOW");
  if (rank && how && how == "stopped_" + where + "_" + rank) std::raise(SIGSTOP);
}

}  // namespace

// The profiling interface of MPI: a program may define MPI's own names, and the library has the same functions as PMPI_...
extern "C" int MPI_Init_thread(int* argc, char*** argv, int required, int* provided) {
  stop_if_told("starting");
  return PMPI_Init_thread(argc, argv, required, provided);
}

extern "C" int MPI_Finalize() {
  stop_if_told("ending");
  return PMPI_Finalize();
}

int main(int argc, char** argv) {
  const std::string how = argv[1];
  const std::string file = argv[2];
  setenv("MPI_JOB_HOW", argv[1], 1);
  return tessera::comm::run_mpi_job(
      argc, argv,
      {.run = [&](Communicator& ranks) { return ranks.rank() == 0 ? lead(ranks, how, file) : work(ranks, how); },
       .report_error = [](const std::string& line) { std::fprintf(stderr, "error: %s\n", line.c_str()); }},
      patience_of(how));
}
