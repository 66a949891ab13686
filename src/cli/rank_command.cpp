#include <memory>

#include "cli/commands.h"
#include "run/ranking_run.h"

namespace tessera::cli {
namespace {

constexpr const char* kRankExamples =
    "Examples:\n"
    "  tessera rank out/campaign                        all results in a folder\n"
    "  tessera rank out/a out/b --out out/a_or_b\n"
    "  tessera rank out/campaign --weight variety=0.2 --weight overlap=-5\n"
    "  tessera rank out/campaign --weight balance=0.1 --weight dwarfs=-0.1    where large and small are to have a "
    "part\n"
    "  tessera rank out/cups --weight colour_from_afar=-2 --weight structure_from_afar=0.5     mosaics of a photo\n"
    "The score is the sum of weight times measure, in percent. By default coverage counts 1, overlap and outside -2,\n"
    "shared_boundary and variety (effective_shapes by pieces: 1 where each shows another shape of one size) 0.1. "
    "Those\n"
    "that count 0 until asked for: balance (1: small to large pieces cover alike), dwarfs (their part of the pieces'\n"
    "area), copies_apart (how far off the nearest copy of a piece is, by the canvas' diagonal), alone (pieces without\n"
    "another within 2 px); of results that show a picture (colour.image), both at 100 px wide, colour_from_afar (how\n"
    "far its colours are off, CIEDE2000: 100 is black for white) and structure_from_afar (SSIM). Equal scores share a\n"
    "rank and stand in the order of their folders' names. The table is written as ranking.csv and ranking.json, the\n"
    "pictures, best first, as ranking.png.";

}  // namespace

void add_rank_command(CLI::App& app, Command& selected) {
  const auto arguments = std::make_shared<RankingArguments>();
  CLI::App* rank = app.add_subcommand("rank", "Compare results by their quality cards");
  rank->footer(kRankExamples);
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
