#include <cstdio>
#include <memory>

#include "cli/collage_input.h"
#include "cli/collage_run.h"
#include "cli/commands.h"

namespace tessera::cli {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  tessera collage jobs/animals.toml\n"
    "  tessera collage jobs/animals.toml --out small --set 'pieces.scale_px=[14, 90]' --set seed=3\n"
    "  mpirun -n 3 tessera collage jobs/animals.toml    rank 0 is the master, the others are workers\n"
    "  tessera collage jobs/animals.toml --time-limit 1:30:00     stops in time; exit code 75: there is more to do\n"
    "  tessera collage jobs/animals.toml --resume                 goes on where it stopped, or was killed\n"
    "  tessera collage jobs/animals.toml --resume=auto            the same, and starts where there is no checkpoint\n"
    "--time-limit takes seconds (90; sbatch would mean minutes), 90s, 90m, 2h, and sbatch's MM:SS, HH:MM:SS, D-HH,\n"
    "D-HH:MM, D-HH:MM:SS, UNLIMITED and INFINITE. --resume=auto starts where there is no checkpoint, leaves a "
    "finished\n"
    "result of the same job as it is, and refuses one of another job.\n"
    "The result (pieces.geojson, quality card, effective job; drawn from them collage.png and .svg) is the same on "
    "any\n"
    "number of ranks, and however often it was interrupted. Ctrl-C, SIGTERM and SIGUSR2 end early: a checkpoint and\n"
    "what is placed so far are written, but not drawn (tessera draw). A finished result in DIR is replaced as soon as\n"
    "a piece is placed; where it is of another job, a line on stderr says so.\n"
    "Every key of a job: docs/job-format.md. Every file of a result: docs/result-format.md";

std::string how_to_go_on(const CollageArguments& arguments) {
  std::string text = "unfinished: go on with the same command and --resume";
  if (arguments.restart) text += " instead of --restart";
  if (arguments.resume == "previous") text += " instead of --resume=previous";
  if (arguments.resume == "auto") text = "unfinished: the same command goes on with it";
  return text;
}

std::string draws_so_far(const CollageArguments& arguments) {
  return "; tessera draw " + output_folder(arguments) + " draws what is placed so far";
}

std::string older_stays(const CollageArguments& arguments) {
  return "; nothing is placed yet, the finished result in " + output_folder(arguments) +
         " is still that of the run before";
}

int run(const CollageArguments& arguments, comm::Communicator& ranks) {
  switch (run_collage(arguments, ranks)) {
    case CollageEnd::finished: return 0;
    case CollageEnd::unfinished:
      std::fprintf(stderr, "tessera: %s\n", (how_to_go_on(arguments) + draws_so_far(arguments)).c_str());
      break;
    case CollageEnd::nothing_placed:
      std::fprintf(stderr, "tessera: %s\n", (how_to_go_on(arguments) + older_stays(arguments)).c_str());
      break;
    case CollageEnd::not_begun:
      std::fprintf(stderr, "tessera: unfinished, before the first round: the same command starts again\n");
      break;
    case CollageEnd::not_drawn:
      std::fprintf(stderr, "tessera: collage finished, drawing interrupted: tessera draw %s goes on\n",
                   output_folder(arguments).c_str());
      break;
  }
  return kUnfinishedExitCode;
}

}  // namespace

void add_collage_command(CLI::App& app, Command& selected) {
  const auto arguments = std::make_shared<CollageArguments>();
  CLI::App* collage = app.add_subcommand("collage", "Make the collage that a job file describes");
  collage->footer(kExamples);
  collage->add_option("JOB", arguments->job, "The job file")->required()->type_name("FILE");
  collage->add_option("--out", arguments->out, "Folder for the result; default: out/<name of the job file>")
      ->type_name("DIR");
  collage->add_option("--set", arguments->overrides, "Use this value instead of the job file's; may be repeated")
      ->type_name("SECTION.KEY=VALUE")
      ->allow_extra_args(false)
      ->take_all();
  collage->add_flag("--quiet", arguments->quiet, "Print neither progress nor the quality card, only warnings");
  CLI::Option* resume =
      collage
          ->add_flag("--resume{latest}", arguments->resume,
                     "Go on from DIR/checkpoint.h5; --resume=previous: from DIR/checkpoint.previous.h5; --resume=auto: "
                     "from the one that is there, if any")
          ->check(CLI::IsMember({"latest", "previous", "auto"}));
  collage->add_flag("--restart", arguments->restart, "Remove the checkpoints in DIR and start again")->excludes(resume);
  collage
      ->add_option_function<std::string>(
          "--time-limit", [arguments](const std::string& limit) { arguments->time_limit = limit; },
          "Stop so early that all is written by then; default: the end of the Slurm job")
      ->type_name("LIMIT");
  collage->callback([arguments, &selected] {
    selected.run_on_all_ranks = [arguments](comm::Communicator& ranks) { return run(*arguments, ranks); };
  });
}

}  // namespace tessera::cli
