#include <memory>

#include "cli/commands.h"
#include "run/campaign_run.h"

namespace tessera::cli {
namespace {

constexpr const char* kCampaignExamples =
    "Examples:\n"
    "  tessera campaign jobs/animals.toml --seeds 1-8\n"
    "  tessera campaign jobs/animals.toml --seeds 1-3 --set objective.gap_weight=0.5,1,2 --out out/gaps\n"
    "  tessera campaign jobs/animals.toml --set 'pieces.scale_px=[20, 160],[14, 90]' --set quality=draft\n"
    "  tessera campaign jobs/animals.toml --seeds 1-8 --list\n"
    "Makes a collage for every combination of seeds and values, and ranks them at the end (see tessera rank). "
    "Finished\n"
    "collages are not made again. A DIR with collages of another job, or of other seeds and values, is refused. A "
    "collage\n"
    "that lacks pieces does not stop the others; the exit code is then 3. --list prints one line for each collage, "
    "for\n"
    "scripts: finished or open, its folder, its values, with tabs between them; a cell that cannot be printed is "
    "written as\n"
    "$'...', as bash quotes it. A campaign runs in one process; slurm/campaign.sh makes an array of jobs of any number "
    "of\n"
    "ranks.";

}  // namespace

void add_campaign_command(CLI::App& app, Command& selected) {
  const auto arguments = std::make_shared<CampaignArguments>();
  CLI::App* campaign =
      app.add_subcommand("campaign", "Make a job's collage with several seeds and values, and rank them");
  campaign->footer(kCampaignExamples);
  campaign->add_option("JOB", arguments->job, "The job file")->required()->type_name("FILE");
  campaign->add_option("--seeds", arguments->seeds, "Seeds and ranges of them; 7 is the seed 7, not seven of them")
      ->type_name("1-8,12");
  campaign->add_option("--set", arguments->sets, "Use each of these values; may be repeated")
      ->type_name("SECTION.KEY=VALUE,..")
      ->allow_extra_args(false)
      ->take_all();
  campaign
      ->add_option("--out", arguments->out,
                   "Folder for the results' folders; default: out/<name of the job file>-campaign")
      ->type_name("DIR");
  campaign
      ->add_option("--weight", arguments->weights,
                   "Weight of a measure in the ranking, as in tessera rank; may "
                   "be repeated")
      ->type_name("NAME=WEIGHT")
      ->allow_extra_args(false)
      ->take_all();
  campaign->add_flag("--list", arguments->list, "Only print the collages and whether they are finished");
  campaign->callback([arguments, &selected] {
    selected.run_on_all_ranks = [arguments](comm::Communicator& ranks) {
      return ranks.rank() == 0 ? run_campaign(*arguments, ranks) : 0;
    };
  });
}

}  // namespace tessera::cli
