#include <memory>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "core/base/error.h"
#include "core/field/free_field.h"
#include "core/matching/sized_settings.h"
#include "job/job_file.h"
#include "job/palette.h"
#include "job/picture_size.h"
#include "plan/plan_estimate.h"
#include "plan/plan_text.h"
#include "run/checked_job.h"
#include "run/messages/collage_warnings.h"
#include "terminal/terminal.h"

namespace tessera::cli {
namespace {

constexpr const char* kPlanExamples =
    "Examples:\n"
    "  tessera plan jobs/animals.toml --ranks 5\n"
    "  tessera plan my.toml --set quality=best          with eight times as much improving as the usual \"good\"\n"
    "  tessera plan jobs/animals.toml --ranks 33 --nodes 4 --set 'canvas.size_px=[8000, 6000]' --set devices.use=gpu\n"
    "Memory, time and checkpoint before the job is run, estimated, and the head of a batch script that fits. Nothing "
    "is\n"
    "computed but the canvas.";

constexpr int kMostRanks = 100'000;

struct PlanArguments {
  std::string job;
  std::vector<std::string> overrides;
  int ranks = 3;
  int nodes = 1;
};

PlanInput plan_input(const PlanArguments& arguments) {
  Job job = load_job(arguments.job, arguments.overrides);
  const LibraryView library = checked_library(job);
  Canvas canvas = checked_canvas(library, job);
  const double room_part = limit_to_room(library, job, canvas);
  if (room_part >= 1) print_warning(outline_alone_warning(job, canvas));
  load_palette(job);  // what is wrong with it shows before the queue, too
  const OutputSpec output = on_paper(job.output, job.canvas, canvas);
  const CollageSettings settings = with_sizes_times(job.size_factor, job.settings);
  const Window nodes = free_field_grid(canvas, settings.pieces).nodes();
  const cv::Size picture_px = picture_size_px(output, canvas);
  const MatchingContext context = make_matching_context(settings, std::uint32_t(library.size()));
  return {.settings = settings,
          .canvas_px2 = room_part * canvas.area_px2,
          .canvas_nodes = double(nodes.width()) * nodes.height(),
          .picture_px2 = double(picture_px.width) * picture_px.height,
          .shapes = library.size(),
          .drawings = library.drawings(),
          .reads = library.stored_models(context) != nullptr,
          .host_devices = job.devices != "gpu",
          .ranks = arguments.ranks,
          .nodes = arguments.nodes};
}

int run(const PlanArguments& arguments) {
  if (arguments.nodes > arguments.ranks) {
    throw InputError("--nodes: found " + std::to_string(arguments.nodes) + ", allowed: 1 to --ranks (" +
                     std::to_string(arguments.ranks) + ")");
  }
  const PlanInput input = plan_input(arguments);
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
  plan->add_option("--ranks", arguments->ranks, "A master and workers")
      ->type_name("N")
      ->check(CLI::Range(1, kMostRanks))
      ->capture_default_str();
  plan->add_option("--nodes", arguments->nodes, "That share the ranks")
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
