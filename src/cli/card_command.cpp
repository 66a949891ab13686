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
    "RESULT is a result's folder, or a FeatureCollection of Polygons and MultiPolygons, a feature a piece, in px of "
    "the\n"
    "canvas with y down;\n"
    "its property shape, where there is one, names what the piece shows. Nothing is asked about who made it and how:\n"
    "coverage, overlap, sizes, copies and contact are those of a quality card (docs/result-format.md).\n"
    "With --image RESULT may be a picture itself, of at most 8192 px each way and 50 million px: a mosaic of any "
    "maker.\n"
    "Both are reduced to 100 px wide and, with --pieces, to a px for each piece; how far colours are off (CIEDE2000)\n"
    "and how alike light and dark lie (SSIM) is told, as a result's card tells it of colour.image. A result's folder "
    "is\n"
    "measured so, too, where its job has one; --image says where the picture is now.";

}  // namespace

void add_card_command(CLI::App& app, Command& selected) {
  const auto arguments = std::make_shared<CardArguments>();
  CLI::App* card = app.add_subcommand("card", "Measure anybody's collage as a quality card does");
  card->footer(kCardExamples);
  card->add_option("RESULT", arguments->pieces, "The pieces as polygons, the folder of a result, or a mosaic")
      ->required()
      ->type_name("FILE");
  card->add_option("--canvas", arguments->canvas, "What was to be filled: an SVG or image, or the job.toml of a result")
      ->type_name("FILE");
  add_list_option(*card, "--size", arguments->size_px,
                  "Of the rectangle, or of the box that the file is scaled into; default: as it was drawn",
                  {.type_name = "W,H", .count = 2});
  add_list_option(*card, "--sizes", arguments->sizes_px,
                  "Sizes that pieces might have had, for the balance; default: the job's where they hold for all "
                  "pieces, else the smallest and the largest",
                  {.type_name = "MIN,MAX", .count = 2});
  card->add_option("--image", arguments->image, "The picture that RESULT shows, an SVG or an image: how well from afar")
      ->type_name("FILE");
  card->add_option("--pieces", arguments->shown_pieces, "How many pieces the picture RESULT has, beside --image")
      ->type_name("N")
      ->check(CLI::Range(1, kMostPieces));
  card->add_flag("--json", arguments->json, "Print JSON");
  card->callback([arguments, &selected] { selected.run = [arguments] { return run_card(*arguments); }; });
}

}  // namespace tessera::cli
