#include "cli/library/library_extract_command.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "artwork/drawers/drawers.h"
#include "cli/library/build_summary.h"
#include "cli/library/library_output.h"
#include "core/base/count_text.h"
#include "core/base/error.h"
#include "core/base/rank_pool.h"
#include "files/atomic_file.h"
#include "files/output_folder.h"
#include "files/output_lock.h"
#include "library/library_builder.h"
#include "products/elements/cut_outs.h"
#include "products/elements/photo_extraction.h"
#include "run/messages/first_picture_warning.h"
#include "terminal/exit_codes.h"
#include "terminal/progress_bar.h"
#include "terminal/terminal.h"

namespace tessera::cli {
namespace {

constexpr char kLibraryExtractExamples[] =
    "Examples:\n"
    "  tessera library extract jigsaw.jpg -o pieces.h5                             elements apart on a plain ground\n"
    "  tessera library extract wall.jpg -o stones.h5 --overview found/             elements side by side\n"
    "  tessera library extract wall.jpg --element-px 120 -o stones.h5              of about this size\n"
    "  tessera library extract beach_*.jpg --element-px 60 --min 30 --max 200 -o pebbles.h5\n"
    "  tessera library extract gravel.jpg --element-px 16 --enlarge 3 -o gravel.h5    elements of few pixels\n"
    "  tessera library extract wall.jpg --element-px 120 -o stones.h5 --ground mortar.png     the mortar, too\n"
    "  tessera library extract wall.jpg --labels wall_labels.png -o stones.h5      labels from another program\n"
    "Reads JPEG, PNG, TIFF, WebP and BMP, turned as their EXIF data say. The library holds the pixels of each "
    "element.\n"
    "Elements cut by the photo's edge are left out. The size of elements that touch, or lie on a ground of several "
    "colours,\n"
    "is found by trying some. Look at the overview: if elements are merged, give a smaller --element-px; if they are "
    "split,\n"
    "a larger one.\n"
    "100 elements take about 5 s, 1000 a minute or two.";

struct ExtractArguments {
  std::vector<std::string> photos;
  std::string output;
  std::string overview;
  std::string ground;  // a file
  int ground_px = 512;
  bool fill_holes = false;
  ExtractionSettings settings;
};

std::string counts_text(const Extraction& extraction, const ExtractionSettings& settings) {
  const FoundElements& found = extraction.found;
  const std::size_t count = found.elements.size();
  std::string text = count_text(count, "element");
  if (settings.element_px == 0 && extraction.element_px > 0) {
    char size[48];
    std::snprintf(size, sizeof size, " of about %.3g px", extraction.element_px);
    text += size;
  }
  const auto add = [&](std::size_t left_out, const char* why) {
    if (left_out > 0) text += ", " + std::to_string(left_out) + " " + why;
  };
  add(found.at_edge, "at the photo's edge left out");
  const bool by_min = extraction.least_px <= settings.sizes.least_px;
  char least[32];
  std::snprintf(least, sizeof least, "smaller than %.3g px", extraction.least_px);
  add(found.too_small, by_min ? "smaller than --min" : least);
  add(found.too_large, "larger than --max");
  add(found.too_many_pixels, "of more than 16 megapixels: a smaller copy of the photo will do");
  if (found.too_small > 0 && !by_min && settings.enlarged < kMostEnlarged)
    text += "; --enlarge " + std::to_string(settings.enlarged + 1) + " or more has smaller ones";
  return text;
}

std::string overview_path(const ExtractArguments& arguments, const std::string& photo) {
  const std::string name = std::filesystem::path(photo).stem().string() + "_found.png";
  return (std::filesystem::path(arguments.overview) / name).string();
}

void write_overview(const ExtractArguments& arguments, const std::string& photo, const std::vector<std::uint8_t>& png) {
  const std::string path = overview_path(arguments, photo);
  write_file_atomically(path, png);
  print_line("  overview: %s", path.c_str());
}

void write_ground(const ExtractArguments& arguments, const Extraction& extraction) {
  write_file_atomically(arguments.ground, extraction.ground_png);
  print_line("  ground: %s, %.0f %% of the photo", arguments.ground.c_str(), 100 * extraction.ground_part);
}

/// The elements of all photos. `complete`: becomes false where a wanted picture of the ground cannot be made.
std::vector<CutOut> all_cut_outs(const ExtractArguments& arguments, Drawers& drawers, bool& complete) {
  std::vector<CutOut> all;
  for (const std::string& photo : arguments.photos) {
    ExtractionSettings settings = arguments.settings;
    if (!arguments.ground.empty() && photo == arguments.photos.front()) settings.ground_px = arguments.ground_px;
    Extraction extraction = extract_elements(photo, settings, drawers);
    print_line("%s: %s", photo.c_str(), counts_text(extraction, settings).c_str());
    if (extraction.touching > 0) {
      print_line("  %s like several that touch: --element-px PX, the short side of a typical one, takes them apart",
                 (std::to_string(extraction.touching) + (extraction.touching == 1 ? " looks" : " look")).c_str());
    }
    if (!arguments.overview.empty()) write_overview(arguments, photo, extraction.overview_png);
    if (!extraction.ground_png.empty()) write_ground(arguments, extraction);
    print_warning(extraction.ground_problem);
    complete = complete && extraction.ground_problem.empty();
    for (CutOut& cut_out : extraction.cut_outs) all.push_back(std::move(cut_out));
  }
  if (all.empty()) {
    throw InputError(arguments.output + " was not written: no element is left of " +
                     (arguments.photos.size() == 1 ? arguments.photos.front() : "these photos") +
                     "; --min and --max leave out elements by size, the photo's edge those that it cuts" +
                     (arguments.settings.labels.empty() ? ", and --element-px says what to look for" : ""));
  }
  return all;
}

LibraryBuildReport build(const ExtractArguments& arguments, const std::vector<CutOut>& cut_outs, Drawers& drawers) {
  ProgressBar bar("library", cut_outs.size());
  const BuildProgress progress = [&](std::size_t done, std::size_t shapes) {
    bar.update(done, count_text(shapes, "shape"));
  };
  LibraryBuildSettings settings;
  settings.files_at_a_time = rank_cores();
  settings.tracing.rules = {.keep_rectangles = true, .fill_holes = arguments.fill_holes};  // for tiles; for rings
  ArtworkFiles files;
  for (const CutOut& cut_out : cut_outs) files.paths.push_back(cut_out.path);
  return build_library(files, arguments.output, settings, cut_out_loader(drawers, cut_outs, settings.tracing),
                       progress);
}

/// Whether both names lead to the same file, which need not exist yet.
bool is_same_path(const std::string& one, const std::string& other) {
  std::error_code error;
  const auto whole = [&](const std::string& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, error), error);
  };
  return whole(one) == whole(other);
}

bool same_file(const std::string& one, const std::string& other) {
  std::error_code error;
  return std::filesystem::equivalent(one, other, error);
}

/// All input files.
std::vector<std::string> inputs(const ExtractArguments& arguments) {
  std::vector<std::string> files = arguments.photos;
  if (!arguments.settings.labels.empty()) files.push_back(arguments.settings.labels);
  return files;
}

/// Checks, before the search, that an option's output replaces no input file.
void check_replaces_no_input(const ExtractArguments& arguments, const std::string& option, const std::string& output) {
  for (const std::string& photo : arguments.photos) {
    if (same_file(output, photo))
      throw InputError(option + ": found the photo " + photo + ", allowed: another file, which is written");
  }
  if (same_file(output, arguments.settings.labels))
    throw InputError(option + ": found the map of --labels, " + output + ", allowed: another file, which is written");
}

/// Checks, before the search, that the ground's file can be written and is no other output.
void check_ground(const ExtractArguments& arguments) {
  const std::filesystem::path ground = arguments.ground;
  std::error_code error;
  if (ground.extension() != ".png")
    throw InputError("--ground: found " + arguments.ground + ", allowed: a name that ends in .png");
  check_replaces_no_input(arguments, "--ground", arguments.ground);
  if (is_same_path(arguments.ground, arguments.output))
    throw InputError("--ground: found " + arguments.ground + ", which is --output, too; allowed: another file");
  if (ground.has_parent_path() && !std::filesystem::is_directory(ground.parent_path(), error))
    throw InputError("--ground: found " + arguments.ground + ", allowed: a file in a folder that is there");
}

/// Checks, before the search, that each photo has an overview file of its own, different from all other files of this
/// run.
void check_overviews(const ExtractArguments& arguments) {
  std::map<std::string, std::string> photo_of_overview;
  for (const std::string& photo : arguments.photos) {
    const std::string overview = overview_path(arguments, photo);
    const auto [other, is_new] = photo_of_overview.try_emplace(overview, photo);
    if (!is_new)
      throw InputError("--overview: " + other->second + " and " + photo + " would both be shown in " + overview +
                       "; allowed: photos with names of their own");
    check_replaces_no_input(arguments, "--overview", overview);
    for (const std::string& output : {arguments.output, arguments.ground}) {
      if (!output.empty() && is_same_path(overview, output))
        throw InputError("--overview: " + photo + " would be shown in " + overview +
                         ", which is written as another output, too; allowed: another folder");
    }
  }
}

void check(const ExtractArguments& arguments) {
  const auto check_number = [](const char* option, double value) {
    if (std::isnan(value)) throw InputError(std::string(option) + ": found nan, allowed: a number");
  };
  check_number("--element-px", arguments.settings.element_px);
  check_number("--min", arguments.settings.sizes.least_px);
  check_number("--max", arguments.settings.sizes.most_px);
  if (arguments.settings.sizes.least_px > arguments.settings.sizes.most_px)
    throw InputError("--min: found more than --max, allowed: at most --max");
  if (!arguments.settings.labels.empty() && arguments.settings.element_px > 0)
    throw InputError("found both --element-px and --labels, allowed: one of them");
  if (!arguments.settings.labels.empty() && arguments.photos.size() > 1)
    throw InputError("--labels: found " + std::to_string(arguments.photos.size()) +
                     " photos, allowed: one, which the map belongs to");
  check_replaces_no_input(arguments, "--output", arguments.output);
  if (!arguments.ground.empty()) check_ground(arguments);
  if (!arguments.overview.empty()) check_overviews(arguments);
}
/// Locks all outputs against other runs, and finds out at once where they cannot be written.
class ExtractOutputs {
 public:
  explicit ExtractOutputs(const ExtractArguments& arguments) : library_(arguments.output + ".lock", arguments.output) {
    check_can_be_written(arguments.output);
    check_is_not_built_from(inputs(arguments), arguments.output);
    check_is_not_built_from(inputs(arguments), arguments.ground);
    if (!arguments.ground.empty()) {
      ground_.emplace(arguments.ground + ".lock", arguments.ground);
      check_can_be_written(arguments.ground);
    }
    if (arguments.overview.empty()) return;
    overview_.emplace(arguments.overview);
    overview_lock_.emplace(folder_lock_path(arguments.overview), arguments.overview);
    for (const std::string& photo : arguments.photos) check_can_be_written(overview_path(arguments, photo));
  }

 private:
  OutputLock library_;
  std::optional<OutputLock> ground_;
  std::optional<OutputFolder> overview_;
  std::optional<OutputLock> overview_lock_;
};

int run(ExtractArguments arguments) {
  check(arguments);
  check_replaceable(arguments.output);
  const ExtractOutputs outputs(arguments);
  arguments.settings.with_overview = !arguments.overview.empty();
  Drawers drawers(photo_drawer_settings(rank_cores()));
  bool complete = true;
  const std::vector<CutOut> cut_outs = all_cut_outs(arguments, drawers, complete);
  print_warning(first_picture_warning(arguments.photos));
  const LibraryBuildReport report = build(arguments, cut_outs, drawers);
  print_lines(build_summary(report));
  if (!report.written) throw InputError(arguments.output + " was not written: no element has a usable silhouette");
  print_line("%s, %s, %.1f MB", arguments.output.c_str(), count_text(report.shapes, "shape").c_str(),
             double(std::filesystem::file_size(arguments.output)) * 1e-6);
  return complete ? kDoneExitCode : kIncompleteExitCode;
}

}  // namespace

// The options, one in a row of the table.
void add_library_extract_command(CLI::App& library, Command& selected) {
  const auto arguments = std::make_shared<ExtractArguments>();
  constexpr double kMostSide_px = 50'000;
  CLI::App* extract =
      library.add_subcommand("extract", "Find stones, tiles, coins in photos and make a library of them");
  extract->footer(kLibraryExtractExamples);
  extract->add_option("PHOTO", arguments->photos, "Photographs, of any number of elements each")->required();
  extract->add_option("-o,--output", arguments->output, "The library file to write, replaced if it exists")
      ->required()
      ->type_name("LIB.h5");
  extract
      ->add_option("--element-px", arguments->settings.element_px,
                   "Short side of a typical element, px of the photo; rather too small than too large. Default: "
                   "found; not needed where elements lie apart on a plain ground")
      ->check(CLI::Range(4.0, kMostSide_px));
  extract
      ->add_option("--min", arguments->settings.sizes.least_px,
                   "Leave out smaller elements: square root of the area, px")
      ->check(CLI::Range(0.0, kMostSide_px));
  extract->add_option("--max", arguments->settings.sizes.most_px, "Leave out larger elements")
      ->check(CLI::Range(0.0, kMostSide_px));
  extract
      ->add_option("--enlarge", arguments->settings.enlarged,
                   "Enlarge the photo by this factor before the search; the other options stay in px of the photo. A "
                   "library needs elements of 24 px (square root of the area), and twice that for good outlines")
      ->check(CLI::Range(1, kMostEnlarged));
  extract->add_flag("--fill-holes", arguments->fill_holes, "Fill the holes of elements, such as rings");
  extract
      ->add_option("--labels", arguments->settings.labels,
                   "Labels of the photo's pixels from another program, instead of a search: grey, 8 or 16 bits, 0 = "
                   "gap")
      ->type_name("MAP.png");
  extract
      ->add_option("--overview", arguments->overview, "Show what was found: FOLDER/PHOTO_found.png, elements numbered")
      ->type_name("FOLDER");
  extract
      ->add_option("--ground", arguments->ground,
                   "Write a picture of what lies between the elements, without seams, for output.ground of a job; of "
                   "several photos that of the first")
      ->type_name("FILE.png");
  extract->add_option("--ground-px", arguments->ground_px, "Its width and height")
      ->type_name("PX")
      ->check(CLI::Range(64, 2048))
      ->needs("--ground");
  extract->callback([arguments, &selected] { selected.run = [arguments] { return run(*arguments); }; });
}

}  // namespace tessera::cli
