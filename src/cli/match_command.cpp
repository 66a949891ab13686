#include <memory>
#include <string>

#include "cli/commands.h"
#include "core/base/error.h"
#include "files/atomic_file.h"
#include "recognition/drawn_curves.h"
#include "recognition/match_picture.h"
#include "recognition/match_text.h"
#include "run/messages/first_picture_warning.h"
#include "terminal/exit_codes.h"
#include "terminal/terminal.h"

namespace tessera::cli {
namespace {

constexpr const char* kMatchExamples =
    "Examples:\n"
    "  tessera match duck.svg goose.svg                     how alike they are, and where\n"
    "  tessera match duck.svg hidden.png -o match.svg       and a picture: matched parts in colour, B laid onto A\n"
    "  tessera match --open letter_a.svg letter_b.png       the centre lines of their strokes\n"
    "  tessera match star.svg star.svg --all 5 --json       its five symmetries, for programs\n"
    "A and B are SVGs, images or masks; outlines are those of their silhouettes, holes too. B may be turned, scaled "
    "and\n"
    "moved, but not mirrored, and may be a part of A, or have a part in common with it. The table shows for each "
    "match:\n"
    "score: how long and how close the matched parts are, 1 for two equal drawings; similarity: how close they are;\n"
    "of A, of B: the matched part of the length. Lengths in JSON are arclengths from the\n"
    "first point of a curve, in units of its drawing: px, or 1/96 inch of an SVG.\n"
    "Exit code 3: nothing matches.";

constexpr int kMostMatches = 1000;
/// Standard deviation of the finest smoothing in px: of silhouettes, and of centre lines, which are rougher.
constexpr float kOutlineSigma_px = 1.5f;
constexpr float kCentreLineSigma_px = 2;

struct MatchArguments {
  std::string a;
  std::string b;
  bool open = false;
  int most = 1;
  std::string picture;
  bool json = false;
};

MatchedCurves read_curves(const std::string& path, bool open, Drawers& drawers) {
  DrawnCurves drawn = read_drawn_curves(path, open ? TracedAs::centre_lines : TracedAs::outlines, drawers);
  return {std::move(drawn.curves), drawn.pixel * (open ? kCentreLineSigma_px : kOutlineSigma_px)};
}

void check_picture(const std::string& picture) {
  if (picture.empty()) return;
  if (!picture.ends_with(".svg")) throw InputError("-o: found " + picture + ", allowed: a name that ends in .svg");
  check_can_be_written(picture);
}

int run(const MatchArguments& arguments) {
  check_picture(arguments.picture);
  Drawers drawers({});
  const MatchedCurves a = read_curves(arguments.a, arguments.open, drawers);
  const MatchedCurves b = read_curves(arguments.b, arguments.open, drawers);
  print_warning(first_picture_warning(std::vector{arguments.a, arguments.b}));
  const std::vector<CurveMatch> matches = matched_curves(a, b, std::size_t(arguments.most));
  if (arguments.json) {
    print_lines(match_json(arguments.a, arguments.b, matches));
  } else if (!matches.empty()) {
    print_lines(match_table(matches));
  }
  if (matches.empty()) {
    print_warning("nothing of " + arguments.b + " matches " + arguments.a +
                  (arguments.picture.empty() ? "" : ": no picture"));
    return kIncompleteExitCode;
  }
  if (!arguments.picture.empty()) {
    write_file_atomically(arguments.picture, std::string_view(match_picture(a.curves, b.curves, matches)));
  }
  return kDoneExitCode;
}

}  // namespace

void add_match_command(CLI::App& app, Command& selected) {
  const auto arguments = std::make_shared<MatchArguments>();
  CLI::App* match =
      app.add_subcommand("match", "Find which parts of two drawings are alike, and lay one onto the other");
  match->footer(kMatchExamples);
  match->add_option("A", arguments->a, "The drawing that B is laid onto")->required()->type_name("FILE");
  match->add_option("B", arguments->b, "The other drawing")->required()->type_name("FILE");
  match->add_flag("--open", arguments->open, "Match centre lines of strokes, not outlines of silhouettes");
  match->add_option("--all", arguments->most, "Number of different matches to report, the best first")
      ->type_name("K")
      ->check(CLI::Range(1, kMostMatches))
      ->capture_default_str();
  match->add_option("-o", arguments->picture, "Write a picture of the matches (SVG)")->type_name("PICTURE.svg");
  match->add_flag("--json", arguments->json, "Print JSON");
  match->callback([arguments, &selected] { selected.run = [arguments] { return run(*arguments); }; });
}

}  // namespace tessera::cli
