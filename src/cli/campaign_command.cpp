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
    "Every seed with every value. Collages that are finished are not made again. A DIR with those of another job, or\n"
    "with some that these seeds and values do not make, is refused; at the end all are ranked (see tessera rank). A "
    "collage that lacks pieces ends no other one, "
    "and\n"
    "the exit code is 3 then. --list prints, for scripts, a line a collage:\n"
    "finished or open, its folder, its values, with tabs between them; a cell of what cannot be printed is $'...', as\n"
    "bash quotes it. One process; slurm/campaign.sh makes an array of jobs of any number of ranks.";

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
  campaign->add_option("--weight", arguments->weights, "Of the ranking, as in tessera rank; may be repeated")
      ->type_name("NAME=WEIGHT")
      ->allow_extra_args(false)
      ->take_all();
  campaign->add_flag("--list", arguments->list, "Only print what there is to do");
  campaign->callback([arguments, &selected] {
    selected.run_on_all_ranks = [arguments](comm::Communicator& ranks) {
      return ranks.rank() == 0 ? run_campaign(*arguments, ranks) : 0;
    };
  });
}

}  // namespace tessera::cli
