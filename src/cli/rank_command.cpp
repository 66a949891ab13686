#include <memory>

#include "cli/commands.h"
#include "cli/ranking_run.h"

namespace tessera::cli {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  tessera rank out/campaign                        all results in a folder\n"
    "  tessera rank out/a out/b --out out/a_or_b\n"
    "  tessera rank out/campaign --weight variety=0.2 --weight overlap=-5\n"
    "The score is the sum of weight times measure, in percent. By default coverage counts 1, overlap and outside -2,\n"
    "shared_boundary 0.1, variety (different shapes by pieces) 0.05. Equal scores share a rank and stand in the order\n"
    "of their folders' names. The table is written as ranking.csv and ranking.json, the pictures, best first, as\n"
    "ranking.png.";

}  // namespace

void add_rank_command(CLI::App& app, Command& selected) {
  const auto arguments = std::make_shared<RankingArguments>();
  CLI::App* rank = app.add_subcommand("rank", "Compare results by their quality cards");
  rank->footer(kExamples);
  rank->add_option("DIR", arguments->folders, "Results, or folders of results")->required()->type_name("DIR...");
  rank->add_option("--out", arguments->out, "Folder for the ranking; default: DIR where there is one, else out/ranking")
      ->type_name("DIR");
  rank->add_option("--weight", arguments->weights, "Change the weight of a measure; may be repeated")
      ->type_name("NAME=WEIGHT")
      ->allow_extra_args(false)
      ->take_all();
  rank->callback([arguments, &selected] { selected.run = [arguments] { return run_ranking(*arguments); }; });
}

}  // namespace tessera::cli
