// tessera: parses the command line and runs the sub-command as one rank of a job, which reports errors once and ends
// all ranks together. Exit codes: exit_codes.h.
#include <malloc.h>
#include <CLI/CLI.hpp>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "cli/commands.h"
#include "cli/exit_codes.h"
#include "comm/in_process_communicator.h"
#include "comm/launcher_check.h"
#include "comm/mpi_guard.h"
#include "comm/rank_program.h"
#include "comm/stop_signals.h"
#include "core/base/error.h"
#include "core/base/version.h"
#include "io/leftover_file.h"

namespace tessera::cli {
namespace {

/// "tessera library build", as far as it was understood.
std::string understood_command(const CLI::App& app) {
  std::string text = app.get_name();
  for (const CLI::App* sub : app.get_subcommands()) text += " " + understood_command(*sub);
  return text;
}

std::string parse_problem(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<std::string> not_understood = app.remaining(true);
  const bool lacks_command = dynamic_cast<const CLI::RequiredError*>(&error) && !not_understood.empty();
  return lacks_command ? "unknown command or option " + not_understood.front() : error.what();
}

/// --help and --version come as errors too.
int end_of_parsing(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) return app.exit(error);
  throw InputError(parse_problem(app, error) + " (see " + understood_command(app) + " --help)");
}

/// For CLI11, last first. It would take what follows "--time-limit=" for the value, be it the job file.
std::vector<std::string> reversed_arguments(int argc, char** argv) {
  constexpr std::string_view kEmptyLimit = "--time-limit=";
  std::vector<std::string> arguments;
  for (int i = argc - 1; i > 0; --i) {
    if (argv[i] == kEmptyLimit) arguments.push_back("");
    arguments.push_back(argv[i] == kEmptyLimit ? "--time-limit" : argv[i]);
  }
  return arguments;
}

int parse_and_run(int argc, char** argv, comm::Communicator& ranks) {
  CLI::App app("Collages of shapes, on one machine or a cluster.", "tessera");
  app.set_version_flag("--version", std::string("tessera ") + program_version() + ", commit " + program_commit());
  app.require_subcommand(1);
  app.footer(
      "First steps:\n"
      "  tessera devices                                  what this machine computes on\n"
      "  tessera library build my_svgs/ -o my.h5          a library from artwork\n"
      "  tessera collage my_job.toml                      a collage from it (docs/job-format.md)\n"
      "  mpirun -n 3 tessera collage my_job.toml          the same on a master and two workers\n"
      "  tessera mosaic my_photo.jpg my.h5                a picture made of it: the job and the collage\n"
      "  tessera puzzle solve pieces.h5 --size 1200,900   a jigsaw's pieces laid together\n"
      "  tessera nest parts.svg --strip 600               shapes of fixed sizes on the shortest strip\n"
      "  tessera refine out/my_job --relax                less room between its pieces: out/my_job-relaxed\n"
      "  tessera draw out/my_job --width 12000            its pictures again, larger\n"
      "  tessera campaign my_job.toml --seeds 1-8         eight of them, ranked by quality\n"
      "  tessera card theirs.geojson --size 1000,800      anybody's collage, by the same measures\n"
      "Exit codes: 0 done, 1 the machine failed (disk, memory, device), 2 bad input, 3 done, but something that was\n"
      "counted is missing (warnings name it), 75 interrupted: --resume goes on.");
  Command selected;
  add_library_command(app, selected);
  add_collage_command(app, selected);
  add_mosaic_command(app, selected);
  add_refine_command(app, selected);
  add_puzzle_command(app, selected);
  add_nest_command(app, selected);
  add_draw_command(app, selected);
  add_campaign_command(app, selected);
  add_plan_command(app, selected);
  add_rank_command(app, selected);
  add_card_command(app, selected);
  add_devices_command(app, selected);
  add_bench_command(app, selected);
  try {
    app.parse(reversed_arguments(argc, argv));
  } catch (const CLI::ParseError& error) {  // the same on every rank
    return ranks.rank() == 0 ? end_of_parsing(app, error) : 0;
  }
  if (selected.run_on_all_ranks) {
    const std::string problem =
        comm::launcher_problem([](const char* name) { return std::getenv(name); }, ranks.size());
    if (!problem.empty()) throw InputError(problem);
    return selected.run_on_all_ranks(ranks);
  }
  return ranks.rank() == 0 ? selected.run() : 0;
}

/// By Open MPI's mpirun, or by srun --mpi=pmix. Without, MPI is left alone: it takes a third of a second to start.
bool started_by_launcher() { return std::getenv("OMPI_COMM_WORLD_SIZE") || std::getenv("PMIX_RANK"); }

/// Vectors of some MB come and go in every round, and of some dozen while a library is loaded. Given back to the system
/// in between, their pages are cleared each time: loading takes a third less without (docs/measurements.md).
void keep_freed_memory() {
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the largest that there is
  mallopt(M_TRIM_THRESHOLD, 64 << 20);
}

int run(int argc, char** argv) {
  keep_freed_memory();
  comm::end_at_once_when_signalled(io::remove_leftover_files);
  std::signal(SIGCHLD, SIG_DFL);  // whoever started us may have ignored it: then nobody learns how a child ended
  const comm::RankProgram program{
      .run = [&](comm::Communicator& ranks) { return parse_and_run(argc, argv, ranks); },
      .report_error = [](const std::string& line) { std::fprintf(stderr, "tessera: %s\n", line.c_str()); }};
  if (started_by_launcher()) return comm::run_mpi_job(argc, argv, program);
  comm::InProcessNetwork alone(1);
  return comm::run_rank(*alone.connect(0), program).exit_code;
}

}  // namespace
}  // namespace tessera::cli

int main(int argc, char** argv) {
  const int exit_code = tessera::cli::run(argc, argv);
  if (exit_code != tessera::cli::kUnfinishedExitCode) return exit_code;
  // A question that was given up may still be compiled by a thread of PoCL's, which crashes where LLVM is taken down.
  std::fflush(nullptr);
  std::_Exit(exit_code);
}
