// tessera: parses the command line and runs the sub-command as one rank of a job, which reports errors once and ends
// all ranks together. Exit codes: exit_codes.h.
#include <malloc.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "cli/commands.h"
#include "comm/in_process_communicator.h"
#include "comm/launcher_check.h"
#include "comm/mpi_guard.h"
#include "comm/rank_program.h"
#include "comm/stop_signals.h"
#include "core/base/error.h"
#include "core/base/kept_memory.h"
#include "core/base/version.h"
#include "files/lack_of_memory.h"
#include "files/leftover_file.h"
#include "run/foreign_end.h"
#include "run/time_limit.h"
#include "terminal/exit_codes.h"
#include "terminal/terminal.h"

namespace tessera::cli {
namespace {

/// "tessera library build", as far as it was understood.
std::string understood_command(const CLI::App& app) {
  std::string text = app.get_name();
  for (const CLI::App* sub : app.get_subcommands()) text += " " + understood_command(*sub);
  return text;
}

std::vector<const CLI::App*> with_all_below(const CLI::App& app) {
  std::vector<const CLI::App*> all = {&app};
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) {
    const std::vector<const CLI::App*> below = with_all_below(*sub);
    all.insert(all.end(), below.begin(), below.end());
  }
  return all;
}

/// CLI11 takes whatever follows "--out" for its value, be it the next option. What is wrong then; empty where nothing is.
std::string swallowed_option(const CLI::App& app, const std::vector<std::string>& words) {
  const std::vector<const CLI::App*> commands = with_all_below(app);
  const auto is_option = [&](const std::string& text) {
    return text.starts_with('-') && std::find(words.begin(), words.end(), text) != words.end() &&
           std::any_of(commands.begin(), commands.end(),
                       [&](const CLI::App* command) { return command->get_option_no_throw(text) != nullptr; });
  };
  for (const CLI::App* command : commands) {
    for (const CLI::Option* option : command->get_options()) {
      if (option->get_positional()) continue;
      const std::vector<std::string> values = option->results();
      const auto swallowed = std::find_if(values.begin(), values.end(), is_option);
      if (swallowed == values.end()) continue;
      const std::string name = option->get_name();
      return name + ": found the option " + *swallowed + ", allowed: a value; one that begins so: " + name + "=" +
             *swallowed;
    }
  }
  return "";
}

/// Where a value is no number CLI11 says neither what is wrong with it nor what is allowed.
std::string conversion_problem(const std::string& problem) {
  constexpr std::string_view kBeginning = "Could not convert: ", kBetween = " = ";
  const std::size_t between = problem.find(kBetween);
  if (!problem.starts_with(kBeginning) || between == problem.npos) return problem;
  const std::string option = problem.substr(kBeginning.size(), between - kBeginning.size());
  const std::string value = problem.substr(between + kBetween.size());
  double number = 0;
  const bool is_number = CLI::detail::lexical_cast(value, number);
  return option + ": found " + value + ", allowed: a " + (is_number ? "whole number that is not too large" : "number");
}

/// `words`: of the command line.
std::string parse_problem(const CLI::App& app, const CLI::ParseError& error, const std::vector<std::string>& words) {
  if (const std::string problem = swallowed_option(app, words); !problem.empty()) return problem;
  const std::vector<std::string> not_understood = app.remaining(true);
  const bool lacks_command = dynamic_cast<const CLI::RequiredError*>(&error) && !not_understood.empty();
  return lacks_command ? "unknown command or option " + not_understood.front() : conversion_problem(error.what());
}

/// That of the sub-command that was given, where there is one.
std::optional<std::string> given_time_limit(const CLI::App& app) {
  for (const CLI::App* sub : app.get_subcommands()) {
    const CLI::Option* limit = sub->get_option_no_throw("--time-limit");
    return limit && limit->count() > 0 ? std::optional(limit->results().back()) : given_time_limit(*sub);
  }
  return std::nullopt;
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

void add_commands(CLI::App& app, Command& selected) {
  app.set_version_flag("--version", std::string("tessera ") + program_version() + ", commit " + program_commit());
  app.require_subcommand(1);
  app.footer(
      "First steps:\n"
      "  tessera devices                                  what this machine computes on\n"
      "  tessera library build my_svgs/ -o my.h5          a library from artwork\n"
      "  tessera collage my_job.toml                      a collage from it (docs/job-format.md)\n"
      "  mpirun -n 3 tessera collage my_job.toml          the same on a master and two workers\n"
      "  tessera mosaic my_photo.jpg my.h5                a picture made of it: the job and the collage\n"
      "  tessera puzzle solve pieces.h5 --size 600,400    a jigsaw's pieces laid together\n"
      "  tessera nest parts.svg --strip 600               shapes of fixed sizes on the shortest strip\n"
      "  tessera refine out/my_job --relax                less room between its pieces: out/my_job-relaxed\n"
      "  tessera draw out/my_job --width 12000            its pictures again, larger\n"
      "  tessera campaign my_job.toml --seeds 1-8         eight of them, ranked by quality\n"
      "  tessera card theirs.geojson --size 1000,800      anybody's collage, by the same measures\n"
      "Exit codes: 0 done, 1 the machine failed (disk, memory, device), 2 bad input, 3 done, but something that was\n"
      "counted is missing (warnings name it), 75 interrupted; the last line on stderr says how to go on.");
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
}

/// The command that the command line asks for. Mistakes in the line become a command that reports them when it is run, and
/// so do --help and --version, which CLI11 takes for errors, too.
Command parsed_command(int argc, char** argv) {
  CLI::App app("Collages of shapes, on one machine or a cluster.", "tessera");
  Command selected;
  const std::vector<std::string> words(argv, argv + argc);
  try {
    add_commands(app, selected);
    app.parse(reversed_arguments(argc, argv));
    if (const std::string problem = swallowed_option(app, words); !problem.empty()) throw CLI::ParseError(problem, 1);
    selected.time_limit = given_time_limit(app);
    return selected;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
      std::ostringstream help;
      app.exit(error, help);
      return {.run = [text = help.str()] {
        print_lines(text);
        return kDoneExitCode;
      }};
    }
    const std::string problem = parse_problem(app, error, words) + " (see " + understood_command(app) + " --help)";
    return {.run = [problem]() -> int { throw InputError(problem); }};
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

/// By Open MPI's mpirun, or by srun --mpi=pmix. Without, MPI is left alone: it takes a third of a second to start.
bool started_by_launcher() { return std::getenv("OMPI_COMM_WORLD_SIZE") || std::getenv("PMIX_RANK"); }

/// Vectors of some MB come and go in every round, and of some dozen while a library is loaded. Given back to the system
/// in between, their pages are cleared each time: loading takes a third less without (docs/measurements.md).
void keep_freed_memory() {
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the largest that there is
  mallopt(M_TRIM_THRESHOLD, int(kKeptFreed_bytes));
}

/// The exit code of a command that is over and has printed all it had to say. Where that was lost, the command has
/// failed; but for one that was interrupted, which is to be called again all the same.
int printed_exit_code(int exit_code) {
  try {
    check_printed();
  } catch (const EnvironmentError& error) {
    if (exit_code != kUnfinishedExitCode) throw;
    print_message(error.what());
  }
  return exit_code;
}

/// Reading of stdout and stderr may end while there is work left, which goes on: writing to them is an error then, not
/// the end of the process.
void ignore_closed_pipes() { std::signal(SIGPIPE, SIG_IGN); }

/// The ranks of a job find each other within its time limit, or they never do. Four ranks on a busy machine take some
/// seconds, however short the limit.
comm::MpiPatience patience_of(const Command& command) {
  constexpr double kLeastStart_s = 10;
  comm::MpiPatience patience;
  try {
    const double limit_s =
        time_limit_s(command.time_limit, std::getenv("SLURM_JOB_END_TIME"), double(std::time(nullptr)), 0);
    patience.start_s = std::clamp(limit_s, kLeastStart_s, patience.start_s);
  } catch (const InputError&) {  // the command says what is wrong with the limit
  }
  return patience;
}

int run(int argc, char** argv) {
  occupy_standard_descriptors();
  ignore_closed_pipes();
  keep_freed_memory();
  comm::end_at_once_when_signalled(remove_leftover_files);
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of its writer, who then cleans up
  std::signal(SIGCHLD, SIG_DFL);  // whoever started us may have ignored it: then nobody learns how a child ended
  const Command command = parsed_command(argc, argv);
  const comm::RankProgram program{
      .run =
          [&](comm::Communicator& ranks) {
            return with_lack_of_memory_named([&] { return printed_exit_code(run_command(command, ranks)); });
          },
      .report_error = print_message};
  if (started_by_launcher()) return comm::run_mpi_job(argc, argv, program, patience_of(command));
  const ForeignEnd end;  // Open MPI, where it is used, has a handler of its own
  comm::InProcessNetwork alone(1);
  return comm::run_rank(*alone.connect(0), program).exit_code;
}

}  // namespace
}  // namespace tessera::cli

int main(int argc, char** argv) {
  const int exit_code = tessera::cli::run(argc, argv);
  if (exit_code != tessera::kUnfinishedExitCode) return exit_code;
  // A question that was given up may still be compiled by a thread of PoCL's, which crashes where LLVM is taken down.
  std::fflush(nullptr);
  std::_Exit(exit_code);
}
