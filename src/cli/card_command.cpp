#include <memory>

#include "cli/commands.h"
#include "program/list_option.h"
#include "run/card_run.h"

namespace tessera::cli {
namespace {

constexpr int kMostPieces = 10'000'000;

constexpr const char* kCardExamples =
    "Examples:\n"
    "  tessera card theirs.geojson --size 1000,800                        on a rectangle\n"
    "  tessera card theirs.geojson --canvas heart.svg --size 1200,1200    in a silhouette, scaled into that box\n"
    "  tessera card theirs.geojson --canvas mask.png --sizes 20,160 --json\n"
    "  tessera card out/animals                                           a result, in its own canvas\n"
    "  tessera card theirs.png --image photo.jpg --pieces 3025            a mosaic, as it is seen from afar\n"
    "RESULT is a result's folder, or a FeatureCollection of Polygons and MultiPolygons in px of the canvas with y "
    "down,\n"
    "one feature for each piece. The property shape of a feature, if it has one, names what the piece shows. Any "
    "program\n"
    "may have made it: the card measures coverage, overlap, sizes, copies and contact as a quality card does\n"
    "(docs/result-format.md).\n"
    "With --image, RESULT may be a picture (a mosaic of any program), of at most 8192 px each way and 50 million px. "
    "Both\n"
    "pictures are reduced to a width of 100 px and, with --pieces, to one px for each piece. The card then reports "
    "the\n"
    "difference of colours (CIEDE2000) and the similarity of structure (SSIM), as a result's card does for "
    "colour.image. A\n"
    "result's folder is measured in the same way if its job has colour.image; --image says where that picture is now.";

}  // namespace

void add_card_command(CLI::App& app, Command& selected) {
  const auto arguments = std::make_shared<CardArguments>();
  CLI::App* card = app.add_subcommand("card", "Measure anybody's collage as a quality card does");
  card->footer(kCardExamples);
  card->add_option("RESULT", arguments->pieces, "The pieces as polygons, the folder of a result, or a mosaic")
      ->required()
      ->type_name("FILE");
  card->add_option("--canvas", arguments->canvas, "The canvas of RESULT: an SVG or image, or the job.toml of a result")
      ->type_name("FILE");
  add_list_option(*card, "--size", arguments->size_px,
                  "Size of the rectangle, or of the box that the file is scaled into; default: as it was drawn",
                  {.type_name = "W,H", .count = 2});
  add_list_option(*card, "--sizes", arguments->sizes_px,
                  "Range of sizes allowed for pieces, to judge their balance; default: the job's where it holds for "
                  "all pieces, else that of the pieces",
                  {.type_name = "MIN,MAX", .count = 2});
  card->add_option("--image", arguments->image,
                   "The picture that RESULT shows, an SVG or an image; the card then "
                   "says how well it is seen from afar")
      ->type_name("FILE");
  card->add_option("--pieces", arguments->shown_pieces, "Number of pieces in the picture RESULT, with --image")
      ->type_name("N")
      ->check(CLI::Range(1, kMostPieces));
  card->add_flag("--json", arguments->json, "Print JSON");
  card->callback([arguments, &selected] { selected.run = [arguments] { return run_card(*arguments); }; });
}

}  // namespace tessera::cli
