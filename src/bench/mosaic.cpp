#include <stdlib.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <opencv2/imgproc.hpp>

#include "bench/baselines/metapixel.h"
#include "bench/baselines/program_run.h"
#include "bench/benchmarks.h"
#include "bench/devices.h"
#include "core/base/error.h"
#include "core/base/stopwatch.h"
#include "files/atomic_file.h"
#include "files/output_folder.h"
#include "job/canvas/overlay.h"
#include "products/mosaic/mosaic_plan.h"
#include "result/card_input.h"
#include "result/mosaic_file.h"
#include "text/csv_text.h"
#include "text/number_text.h"
#include "text/text_table.h"

namespace tessera::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOurs = "tessera";

struct SeenMosaic {
  std::string image;
  std::string maker;  // kOurs, or metapixel with its ground
  std::string picture;
  std::size_t pieces = 0;
  double seconds = 0;  // from the command to the picture
  SeenFromAfar seen;
};

/// A temporary folder.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "tessera-bench-XXXXXX").string();
    if (!mkdtemp(name.data())) throw EnvironmentError("cannot create a folder like " + name);
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// The options with defaults for those that are not given.
MosaicOptions whole(MosaicOptions options, bool quick) {
  const MosaicOptions defaults;
  if (options.grounds.empty()) options.grounds = {"#f3f0ec", "#404040"};
  if (quick && options.pieces == defaults.pieces) options.pieces = kFewestMosaicPieces;
  return options;
}

void check(const MosaicOptions& options) {
  if (std::getenv("OMPI_COMM_WORLD_SIZE"))
    throw InputError("bench mosaic starts tessera mosaic itself: give it without mpirun");
  if (options.pieces < kFewestMosaicPieces || options.pieces > kMostMosaicPieces) {
    throw InputError("--pieces: found " + std::to_string(options.pieces) +
                     "; allowed: " + std::to_string(kFewestMosaicPieces) + " to " + std::to_string(kMostMosaicPieces));
  }
  for (const std::string& ground : options.grounds) {
    if (ground.size() != 7 || ground[0] != '#' ||
        ground.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string::npos) {
      throw InputError("--grounds: found " + ground + "; allowed: #rrggbb, with commas between several");
    }
  }
}

/// The image as opaque BGR, as tessera mosaic uses it.
cv::Mat image_of(const std::string& path) {
  Drawers drawers(photo_drawer_settings(1));
  cv::Mat bgr;
  cv::cvtColor(whole_overlay(path, "--image", 1024, drawers), bgr, cv::COLOR_BGRA2BGR);
  return bgr;
}

/// The beginning of file names in the folder: several images may have the same name.
std::string name_of(std::size_t number, const std::string& image) {
  return std::to_string(number + 1) + "_" + fs::path(image).stem().string();
}

SeenMosaic our_mosaic(const Setting& setting, const MosaicOptions& options, const std::string& image,
                      const std::string& stem) {
  std::vector<std::string> command = {options.program,
                                      "mosaic",
                                      image,
                                      options.library,
                                      "--pieces",
                                      std::to_string(options.pieces),
                                      "--job",
                                      stem + ".toml",
                                      "--out",
                                      stem,
                                      "--replace",
                                      "--restart",
                                      "--quiet",
                                      "--set",
                                      "devices.use=" + setting.devices};
  for (const std::string& key : options.settings) command.insert(command.end(), {"--set", key});
  const Stopwatch watch;
  run_program(command);
  const double seconds = watch.seconds();
  const ResultCard card = read_card(stem);
  if (!card.afar) throw EnvironmentError(stem + "/card.json: does not say what is seen from afar");
  return {image, kOurs, stem + "/collage.png", card.quality.pieces, seconds, *card.afar};
}

SeenMosaic peers_mosaic(const LibraryFile& library, const std::string& image, const std::string& ground,
                        std::size_t pieces, const std::string& stem) {
  const ScratchFolder scratch;
  const cv::Mat picture = image_of(image);
  const TileGrid grid = tile_grid(picture.size(), pieces);
  const Tiles tiles = write_tiles(library, ground, scratch.path());
  const std::string mosaic = stem + "_metapixel_" + ground.substr(1) + ".png";
  const std::string shown = write_tiled_image(picture, grid, tiles);
  const Stopwatch watch;
  make_metapixel_mosaic(tiles, shown, grid, mosaic);
  const double seconds = watch.seconds();
  const auto count = std::size_t(grid.columns) * std::size_t(grid.rows);
  return {image, "metapixel on " + ground, mosaic, count, seconds, mosaic_from_afar(mosaic, {shown}, count)};
}

std::string table_of(const std::vector<SeenMosaic>& outcomes) {
  TextTable table({"mosaic", "image", "pieces", "CIEDE2000", "SSIM", "at a piece's size", "SSIM", "s"});
  for (const SeenMosaic& o : outcomes) {
    const auto& piece = o.seen.at_piece_size;
    table.add({o.maker, fs::path(o.image).filename().string(), std::to_string(o.pieces),
               fixed(o.seen.at_100_px.colour_difference, 2), fixed(o.seen.at_100_px.structure, 3),
               piece ? fixed(piece->colour_difference, 2) : "-", piece ? fixed(piece->structure, 3) : "-",
               fixed(o.seconds, 1)});
  }
  return table.text();
}

Json figures_json(const AfarFigures& figures) {
  return {{"width_px", figures.width_px},
          {"height_px", figures.height_px},
          {"ciede2000", rounded(figures.colour_difference)},
          {"ssim", rounded(figures.structure)}};
}

Json row_json(const SeenMosaic& o) {
  const auto& piece = o.seen.at_piece_size;
  return {{"image", o.image},
          {"mosaic", o.maker},
          {"picture", o.picture},
          {"pieces", o.pieces},
          {"at_100_px", figures_json(o.seen.at_100_px)},
          {"at_piece_size", piece ? figures_json(*piece) : Json()},
          {"seconds", rounded(o.seconds)}};
}

std::string csv_of(const std::vector<SeenMosaic>& outcomes) {
  std::string text = "image,mosaic,pieces,ciede2000,ssim,piece_ciede2000,piece_ssim,seconds\n";
  for (const SeenMosaic& o : outcomes) {
    text += csv_text_cell(o.image) + "," + csv_text_cell(o.maker) + "," + std::to_string(o.pieces) + "," +
            fixed(o.seen.at_100_px.colour_difference, 3) + "," + fixed(o.seen.at_100_px.structure, 3);
    const auto& piece = o.seen.at_piece_size;
    text += piece ? "," + fixed(piece->colour_difference, 3) + "," + fixed(piece->structure, 3) : ",,";
    text += "," + fixed(o.seconds, 3) + "\n";
  }
  return text;
}

/// Makes our mosaic of each image, and, where metapixel is installed, its mosaic with as many pieces. The pictures go
/// into `folder`.
std::vector<SeenMosaic> made_mosaics(const Setting& setting, const MosaicOptions& options, const LibraryFile& library,
                                     const std::string& folder, bool with_peer) {
  std::vector<SeenMosaic> outcomes;
  for (std::size_t i = 0; i < options.images.size(); ++i) {
    const std::string& image = options.images[i];
    const std::string stem = folder + "/" + name_of(i, image);
    setting.progress(image + ": tessera mosaic");
    outcomes.push_back(our_mosaic(setting, options, image, stem));
    const std::size_t pieces = outcomes.back().pieces;
    for (const std::string& ground : options.grounds) {
      if (!with_peer) break;
      setting.progress(image + ": metapixel, drawings on " + ground);
      outcomes.push_back(peers_mosaic(library, image, ground, pieces, stem));
    }
  }
  return outcomes;
}

}  // namespace

Report bench_mosaic(const Setting& setting, const MosaicOptions& asked) {
  const MosaicOptions options = whole(asked, setting.quick);
  check(options);
  const LibraryFile library(options.library);
  for (const std::string& image : options.images) image_of(image);  // before the work: a mistyped name costs no time
  const std::string folder = fs::path(setting.out).replace_extension().string();
  make_folder(folder);
  const std::string csv = folder + ".csv";
  check_can_be_written(csv);
  const bool with_peer = has_metapixel();
  const std::vector<SeenMosaic> outcomes = made_mosaics(setting, options, library, folder, with_peer);
  write_file_atomically(csv, csv_of(outcomes));

  Report report;
  report.json = report_head("mosaic", setting);
  report.json.update({{"library", options.library},
                      {"drawings", library.size()},
                      {"pieces", options.pieces},
                      {"set", options.settings},
                      {"metapixel", with_peer},
                      {"rows", Json::array()}});
  for (const SeenMosaic& outcome : outcomes) report.json["rows"].push_back(row_json(outcome));
  report.text =
      table_of(outcomes) + "\n" + std::to_string(library.size()) +
      " drawings. Seen from afar: 100 px wide, then with a px for each piece. CIEDE2000: how far colours are "
      "off, 0 is best; SSIM:\nhow alike light and dark lie, 1 is best. The pictures lie in " +
      folder + ".\n" +
      (with_peer ? "metapixel: tiles in rows, a drawing at least two tiles from itself where there are enough.\n"
                 : "metapixel is not installed (Debian's package metapixel): ours alone.\n");
  return report;
}

}  // namespace tessera::bench
