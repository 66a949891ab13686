#include <memory>

#include "cli/collage_options.h"
#include "cli/commands.h"

namespace tessera::cli {
namespace {

constexpr const char* kCollageExamples =
    "Examples:\n"
    "  tessera collage jobs/animals.toml\n"
    "  tessera collage jobs/animals.toml --out small --set 'pieces.scale_px=[14, 90]' --set seed=3\n"
    "  tessera collage my.toml --set quality=draft      a quick look: the first filling, not improved\n"
    "  mpirun -n 3 tessera collage jobs/animals.toml    rank 0 is the master, the others are workers\n"
    "  tessera collage jobs/animals.toml --time-limit 1:30:00     stops in time; exit code 75: there is more to do\n"
    "  tessera collage jobs/animals.toml --resume                 goes on where it stopped, or was killed\n"
    "  tessera collage jobs/animals.toml --resume=auto            the same, and starts where there is no checkpoint\n"
    "Exit code 3: finished, but pieces are missing that the job counts (least uses, fit = \"all\"), or there are "
    "none;\n"
    "stderr and the card name them.\n"
    "--time-limit takes seconds (90; sbatch would mean minutes), 90s, 90m, 2h, and sbatch's MM:SS, HH:MM:SS, D-HH,\n"
    "D-HH:MM, D-HH:MM:SS, UNLIMITED and INFINITE. --resume=auto starts where there is no checkpoint, leaves a "
    "finished\n"
    "result of the same job as it is, and refuses one of another job.\n"
    "Once nothing more fits the collage is improved as the job's key quality says: good, unless it says draft or\n"
    "best, or [improve] has a number.\n"
    "The result (pieces.geojson, quality card, effective job; drawn from them collage.png and .svg) is the same on "
    "any\n"
    "number of ranks, and however often it was interrupted. Ctrl-C, SIGTERM and SIGUSR2 end early: a checkpoint and\n"
    "what is placed so far are written, but not drawn (tessera draw). A finished result in DIR is replaced as soon as\n"
    "a piece is placed; where it is of another job, a line on stderr says so.\n"
    "Every key of a job: docs/job-format.md. Every file of a result: docs/result-format.md";

}  // namespace

void add_collage_command(CLI::App& app, Command& selected) {
  const auto arguments = std::make_shared<CollageArguments>();
  CLI::App* collage = app.add_subcommand("collage", "Make the collage that a job file describes");
  collage->footer(kCollageExamples);
  collage->add_option("JOB", arguments->job, "The job file")->required()->type_name("FILE");
  add_collage_options(*collage, *arguments);
  collage->callback([arguments, &selected] {
    selected.run_on_all_ranks = [arguments](comm::Communicator& ranks) { return collage_exit_code(*arguments, ranks); };
  });
}

}  // namespace tessera::cli
