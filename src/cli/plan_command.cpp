#include <memory>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "core/base/error.h"
#include "job/job_file.h"
#include "plan/plan_estimate.h"
#include "plan/plan_input.h"
#include "plan/plan_text.h"
#include "run/collage_problem.h"
#include "run/messages/collage_warnings.h"
#include "terminal/terminal.h"

namespace tessera::cli {
namespace {

constexpr const char* kPlanExamples =
    "Examples:\n"
    "  tessera plan jobs/animals.toml --ranks 5\n"
    "  tessera plan my.toml --set quality=best          with eight times as much improving as the usual \"good\"\n"
    "  tessera plan jobs/animals.toml --ranks 33 --nodes 4 --set 'canvas.size_px=[8000, 6000]' --set devices.use=gpu\n"
    "Estimates memory, time and the size of the checkpoint before the job runs, and prints the head of a batch script "
    "that\n"
    "fits. Only the canvas is computed.";

constexpr int kMostRanks = 100'000;

struct PlanArguments {
  std::string job;
  std::vector<std::string> overrides;
  PlanRanks on;
};

int run(const PlanArguments& arguments) {
  if (arguments.on.nodes > arguments.on.ranks) {
    throw InputError("--nodes: found " + std::to_string(arguments.on.nodes) + ", allowed: 1 to --ranks (" +
                     std::to_string(arguments.on.ranks) + ")");
  }
  const CanvasProblem problem(load_job(arguments.job, arguments.overrides));
  if (problem.found().room_part >= 1) print_warning(outline_alone_warning(problem.job().canvas, problem.canvas()));
  const PlanInput input = plan_input(problem, arguments.on);
  const PlanEstimate plan = estimate(input);
  print_warning(idle_workers_warning(input, plan));
  print_lines(plan_text(input, plan) + "\n" + sbatch_header(input, plan));
  return 0;
}

}  // namespace

void add_plan_command(CLI::App& app, Command& selected) {
  const auto arguments = std::make_shared<PlanArguments>();
  CLI::App* plan = app.add_subcommand("plan", "Estimate what a job needs on a cluster");
  plan->footer(kPlanExamples);
  plan->add_option("JOB", arguments->job, "The job file")->required()->type_name("FILE");
  plan->add_option("--ranks", arguments->on.ranks, "Number of ranks: a master and workers")
      ->type_name("N")
      ->check(CLI::Range(1, kMostRanks))
      ->capture_default_str();
  plan->add_option("--nodes", arguments->on.nodes, "Number of nodes that share the ranks")
      ->type_name("M")
      ->check(CLI::Range(1, kMostRanks))
      ->capture_default_str();
  plan->add_option("--set", arguments->overrides, "Use this value instead of the job file's; may be repeated")
      ->type_name("SECTION.KEY=VALUE")
      ->allow_extra_args(false)
      ->take_all();
  plan->callback([arguments, &selected] { selected.run = [arguments] { return run(*arguments); }; });
}

}  // namespace tessera::cli
