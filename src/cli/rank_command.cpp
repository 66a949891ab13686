#include <memory>

#include "cli/commands.h"
#include "run/results/ranking_run.h"

namespace tessera::cli {
namespace {

constexpr const char* kRankExamples =
    "Examples:\n"
    "  tessera rank out/campaign                        all results in a folder\n"
    "  tessera rank out/a out/b --out out/a_or_b\n"
    "  tessera rank out/campaign --weight variety=0.2 --weight overlap=-5\n"
    "  tessera rank out/campaign --weight balance=0.1 --weight dwarfs=-0.1    if sizes shall be balanced\n"
    "  tessera rank out/cups --weight colour_from_afar=-2 --weight structure_from_afar=0.5     mosaics of a photo\n"
    "The score is the sum of weight times measure, in percent. Default weights: coverage 1, overlap and outside -2,\n"
    "shared_boundary and variety (effective_shapes / pieces: 1 if all pieces show different shapes in one size) 0.1. "
    "These\n"
    "have the weight 0 unless it is given: balance (1: small, medium and large pieces cover the same area), dwarfs "
    "(their\n"
    "part of the pieces' area), copies_apart (distance of the nearest copy of a piece / the canvas' diagonal), alone "
    "(pieces\n"
    "without another one within 2 px). For results that show a picture (colour.image), at a width of 100 px:\n"
    "colour_from_afar (difference of colours, CIEDE2000: 100 is black instead of white) and structure_from_afar "
    "(SSIM).\n"
    "Equal scores share a rank, in the order of their folders' names. The table is written as ranking.csv and "
    "ranking.json,\n"
    "the pictures, best first, as ranking.png, and all of it as ranking.html, a page that sorts and compares (tessera\n"
    "report).";

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
