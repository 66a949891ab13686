// element_bench PHOTO TRUTH.png ...: compares the elements that the search finds in photos with truth maps, which were
// marked by hand (bench/truth). It searches like `tessera texture`.
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "artwork/drawers/drawers.h"
#include "artwork/images/png_encoder.h"
#include "bench_main.h"
#include "core/base/rank_pool.h"
#include "element_truth.h"
#include "files/atomic_file.h"
#include "files/regular_file.h"
#include "products/elements/photo_extraction.h"
#include "products/elements/segmentation/region_labels.h"
#include "text/number_text.h"

namespace tessera::bench {
namespace {

namespace fs = std::filesystem;

/// Longest side of a picture of the comparison, about: photos are enlarged by whole numbers.
constexpr int kPictureSide_px = 1600;
// Colours, BGR.
const cv::Scalar kMatched(0, 200, 0), kFalse(0, 0, 255), kNotCounted(170, 170, 170), kNotTaken(255, 128, 0);
const cv::Scalar kTruth(0, 255, 255), kMissed(255, 0, 255);

struct Options {
  std::vector<std::string> files;  // a photo and its truth map, in turn
  double element_px = 0;           // 0: found
  std::string pictures;            // a folder; empty: none
};

Options parsed(int argc, char** argv) {
  Options options;
  CLI::App app("How many elements of photos the search finds, beside truth maps.", "element_bench");
  app.add_option("PHOTO TRUTH.png", options.files, "A photo and its truth map, in turn")->required();
  app.add_option("--element-px", options.element_px, "Short side of an element, px of the photo; default: found")
      ->check(CLI::PositiveNumber);
  app.add_option("--pictures", options.pictures,
                 "Draws the comparison by masks into FOLDER/eval_TRUTH.png: truth yellow, missed ones magenta; found "
                 "elements green, false ones red, those in ignored places grey; regions too small or at the edge blue")
      ->type_name("FOLDER");
  app.callback([&] {
    if (options.files.size() % 2 != 0) throw CLI::ValidationError("found a photo without a truth map");
  });
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::exit(app.exit(error));
  }
  return options;
}

/// A number, and the part of all that it is.
std::string with_part(std::size_t count, std::size_t all) {
  return std::to_string(count) + " (" + (all == 0 ? "-" : fixed(100. * double(count) / double(all), 0) + " %") + ")";
}

/// Two cells: what was found, with the recall, and what is false, with the precision.
std::string matches_text(const TruthComparison& comparison, const std::vector<TruthMatch>& matches) {
  const std::size_t found = matches.size(), counted = comparison.counted();
  return with_part(found, comparison.whole.size()) + " | " + std::to_string(counted - found) + " (" +
         (counted == 0 ? "-" : fixed(100. * double(found) / double(counted), 0) + " %") + ")";
}

/// How exact the outlines of matched elements are. `matches`: the greatest overlaps first.
std::string median_overlap(const std::vector<TruthMatch>& matches) {
  return matches.empty() ? "-" : fixed(matches[matches.size() / 2].overlap, 2);
}

void print_head() {
  std::printf(
      "| photo | size found | whole | found by boxes (recall) | false (precision) | found by masks (recall) | false "
      "(precision) | median overlap | split | merged | processor time "
      "|\n|---|---|---|---|---|---|---|---|---|---|---|\n");
}

void print_row(const std::string& photo, const PhotoComparison& result) {
  const TruthComparison& comparison = result.comparison;
  const double size_px = result.extraction.element_px;
  std::printf("| %s | %s | %zu | %s | %s | %s | %zu | %zu | %s s |\n", fs::path(photo).filename().c_str(),
              size_px > 0 ? (fixed(size_px, 0) + " px").c_str() : "plain ground", comparison.whole.size(),
              matches_text(comparison, comparison.by_boxes).c_str(),
              matches_text(comparison, comparison.by_masks).c_str(), median_overlap(comparison.by_masks).c_str(),
              comparison.split.size(), comparison.merged.size(), fixed(result.processor_s, 0).c_str());
  std::fflush(stdout);
}

/// Draws the outline of a mask whose upper left corner is at `corner`. `scale`: of the picture, relative to the mask.
void draw_outline(cv::Mat& picture, const cv::Mat& mask, cv::Point corner, double scale, const cv::Scalar& colour) {
  std::vector<std::vector<cv::Point>> curves;
  cv::findContours(mask, curves, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE, corner);
  for (std::vector<cv::Point>& curve : curves) {
    for (cv::Point& point : curve) point = {int((point.x + 0.5) * scale), int((point.y + 0.5) * scale)};
  }
  cv::drawContours(picture, curves, -1, colour, 2, cv::LINE_AA);
}

cv::Mat picture_of(const cv::Mat& photo, const PhotoComparison& result) {
  const Extraction& extraction = result.extraction;
  const TruthComparison& comparison = result.comparison;
  const int zoom = std::max(1, kPictureSide_px / std::max(photo.cols, photo.rows));
  const double scale = double(zoom) / extraction.enlarged;
  cv::Mat picture;
  cv::resize(photo, picture, photo.size() * zoom, 0, 0, cv::INTER_CUBIC);
  cv::cvtColor(picture, picture, cv::COLOR_BGRA2BGR);
  const auto is_matched = [&](auto member, auto value) {
    return std::any_of(comparison.by_masks.begin(), comparison.by_masks.end(),
                       [&](const TruthMatch& match) { return match.*member == value; });
  };
  const std::vector<RegionBox> regions = region_boxes(result.truth);
  for (const int label : comparison.whole) {
    const cv::Rect box = regions[std::size_t(label)].box;
    draw_outline(picture, result.truth(box) == label, box.tl(), scale,
                 is_matched(&TruthMatch::truth, label) ? kTruth : kMissed);
  }
  const LabelRuns& labels = *extraction.labels;
  const auto draw_region = [&](std::size_t label, const cv::Scalar& colour) {
    draw_outline(picture, labels.mask_of(label), labels.regions()[label].box.tl(), scale, colour);
  };
  for (std::size_t label = 1; label < extraction.roles.size(); ++label) {
    if (labels.regions()[label].area_px2 > 0 && extraction.roles[label] != LabelRole::element)
      draw_region(label, kNotTaken);
  }
  for (std::size_t i = 0; i < extraction.found.elements.size(); ++i) {
    const cv::Scalar colour = is_matched(&TruthMatch::element, i) ? kMatched
                              : comparison.is_counted[i]          ? kFalse
                                                                  : kNotCounted;
    draw_region(std::size_t(extraction.found.elements[i].label), colour);
  }
  return picture;
}

void run(const Options& options) {
  Drawers drawers(photo_drawer_settings(rank_cores()));
  print_head();
  for (std::size_t i = 0; i < options.files.size(); i += 2) {
    const std::string &photo = options.files[i], &map = options.files[i + 1];
    const PhotoComparison result = compared_photo(photo, map, options.element_px, drawers);
    print_row(photo, result);
    if (options.pictures.empty()) continue;
    const cv::Mat pixels = drawers.photo(read_regular_file(photo, kMaxPhotoBytes), photo);
    write_file_atomically(fs::path(options.pictures) / ("eval_" + fs::path(map).stem().string() + ".png"),
                          png_of(picture_of(pixels, result)));
  }
}

}  // namespace
}  // namespace tessera::bench

int main(int argc, char** argv) {
  using namespace tessera::bench;
  return exit_code_of("element_bench", [&] { run(parsed(argc, argv)); });
}
