#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cli/collage_options.h"
#include "cli/collage_source.h"
#include "cli/commands.h"
#include "cli/first_collage.h"
#include "core/base/error.h"
#include "program/list_option.h"
#include "run/job_output.h"

namespace tessera::cli {
namespace {

constexpr const char* kCollageExamples =
    "Examples:\n"
    "  tessera collage my_drawings/                     a first collage: builds out/my_drawings.h5, writes\n"
    "                                                   my_drawings.toml and runs it\n"
    "  tessera collage my_drawings/ --canvas heart.svg --size 1200,800\n"
    "  tessera collage jobs/animals.toml\n"
    "  tessera collage jobs/animals.toml --out small --set 'pieces.scale_px=[14, 90]' --set seed=3\n"
    "  tessera collage my.toml --set quality=draft      a quick look: the first filling, not improved\n"
    "  mpirun -n 3 tessera collage jobs/animals.toml    rank 0 is the master, the others are workers\n"
    "  tessera collage jobs/animals.toml --time-limit 1:30:00     stops in time; exit code 75: interrupted\n"
    "  tessera collage jobs/animals.toml --resume                 continues where it stopped or was killed\n"
    "  tessera collage jobs/animals.toml --resume=auto            continues, or starts where there is no checkpoint\n"
    "Exit code 3: finished, but the collage lacks pieces that the job requires (least uses, fit = \"all\"), or has "
    "none;\n"
    "stderr and the card name them. Exit code 75: interrupted; --resume continues.\n"
    "--time-limit takes seconds (90; sbatch would mean minutes), 90s, 90m, 2h, and sbatch's MM:SS, HH:MM:SS, D-HH,\n"
    "D-HH:MM, D-HH:MM:SS, UNLIMITED and INFINITE. --resume=auto starts where there is no checkpoint, leaves a "
    "finished\n"
    "result of the same job as it is, and refuses one of another job.\n"
    "Once nothing more fits, the collage is improved. The job's key quality says how much: good, draft or best; "
    "default:\n"
    "good. Numbers in [improve] replace it.\n"
    "The result (pieces.geojson, quality card, effective job; drawn from them collage.png and .svg) is the same on "
    "any\n"
    "number of ranks, and however often it was interrupted. Ctrl-C, SIGTERM and SIGUSR2 end early: the run\n"
    "writes a checkpoint and the pieces so far, but no pictures (tessera draw makes them). A finished result in DIR "
    "is\n"
    "replaced as soon as a piece is placed; if it is of another job, a line on stderr says so.\n"
    "Every key of a job: docs/job-format.md. Every file of a result: docs/result-format.md";

struct CollageCommand {
  CollageArguments collage;
  FirstCollageArguments first;
};

/// Refuses --job, --canvas and --size beside a job: they describe a first collage, and a job has keys for that.
void check_has_no_first_options(const FirstCollageArguments& first) {
  constexpr const char* kAllowed = ": allowed with a folder of drawings or a library";
  if (!first.job.empty()) throw InputError(std::string("--job") + kAllowed);
  if (!first.canvas.empty())
    throw InputError(std::string("--canvas") + kAllowed + "; for a job use --set canvas.file=FILE");
  if (first.size_px)
    throw InputError(std::string("--size") + kAllowed + "; for a job use --set 'canvas.size_px=[W, H]'");
}

int run(CollageCommand command, comm::Communicator& ranks) {
  FirstCollageArguments& first = command.first;
  const CollageSource source = collage_source(command.collage.job);
  if (source == CollageSource::job) {
    check_has_no_first_options(first);
    return collage_exit_code(command.collage, ranks);
  }
  first.source = command.collage.job;
  first.is_library = source == CollageSource::library;
  command.collage.job = first_job_path(first);
  // Only rank 0 reads the drawings; it sends the job to the workers, as any job.
  if (ranks.rank() != 0) return collage_exit_code(command.collage, ranks);
  const JobOutput output(command.collage, {}, false);
  write_first_job(first, command.collage);
  return collage_exit_code(command.collage, ranks);
}

}  // namespace

void add_collage_command(CLI::App& app, Command& selected) {
  const auto arguments = std::make_shared<CollageCommand>();
  CLI::App* collage =
      app.add_subcommand("collage", "Make the collage that a job describes, or a first one of a folder of drawings");
  collage->footer(kCollageExamples);
  collage->add_option("JOB", arguments->collage.job, "A job file; or a folder of drawings, or a library")
      ->required()
      ->type_name("FILE|FOLDER");
  collage
      ->add_option("--canvas", arguments->first.canvas,
                   "For a folder: an SVG or a picture whose silhouette the drawings fill; default: a rectangle")
      ->type_name("FILE");
  collage
      ->add_option("--job", arguments->first.job,
                   "For a folder: the job file to write; default: <name of the folder>.toml, with --canvas "
                   "<name>_<canvas>.toml")
      ->type_name("FILE.toml");
  add_list_option<int>(*collage, "--size",
                       [arguments](std::vector<int> given) { arguments->first.size_px = std::move(given); },
                       "For a folder: width and height of the canvas, px; default: 1200,900, with --canvas 1200,1200",
                       {.type_name = "W,H", .count = 2, .value = CLI::Range(16, 20'000)});
  add_collage_options(*collage, arguments->collage);
  collage->callback([arguments, &selected] {
    selected.run_on_all_ranks = [arguments](comm::Communicator& ranks) { return run(*arguments, ranks); };
  });
}

}  // namespace tessera::cli
