#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "cli/collage_options.h"
#include "cli/commands.h"
#include "core/base/error.h"
#include "core/puzzle/puzzle_solver.h"
#include "io/puzzle/puzzle_making.h"
#include "io/puzzle/puzzle_solving.h"
#include "io/utf8_text.h"

namespace tessera::cli {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  tessera puzzle make photo.jpg --pieces 36 --out jigsaw      jigsaw/pieces/piece_001.png ..., jigsaw/truth\n"
    "  tessera library build jigsaw/pieces -o jigsaw.h5 --keep-rectangles\n"
    "  tessera puzzle solve jigsaw.h5 --size 1200,900              out/jigsaw: where they belong";

constexpr const char* kMakeExamples =
    "Examples:\n"
    "  tessera puzzle make photo.jpg --pieces 36 --out jigsaw\n"
    "  tessera puzzle make photo.jpg --pieces 18 --cut polygons --seed 3 --out shards\n"
    "Each piece is a PNG with transparency, turned by a random angle; pieces are numbered in a random order.\n"
    "DIR/truth/pieces.geojson says where each lay, px of the picture. Of tabs there may be a few pieces more or\n"
    "fewer, rows times columns. What to type next is printed.";

constexpr const char* kSolveExamples =
    "Examples:\n"
    "  tessera puzzle solve jigsaw.h5 --size 1200,900              pieces of any scale fill a frame of that size\n"
    "  tessera puzzle solve jigsaw.h5 --size 1200,900 --scale 1    they are known to be as large as they were drawn\n"
    "  tessera puzzle solve jigsaw.h5                              no frame: the canvas is as large as what comes out\n"
    "  tessera puzzle solve jigsaw.h5 --size 1200,900 --truth jigsaw/truth     how far from it\n"
    "LIB.h5 holds the pieces, each once, in one scale among themselves: as large as their pictures. What fits is\n"
    "found by outlines alone, so a frame may come out upside down, and pieces need corners. jigsaw_pieces.geojson\n"
    "says where they lie, jigsaw.toml is a job that shows it, which is then run as by tessera collage. Pieces that\n"
    "found no place are named, and the others laid: the exit code is 0 all the same.";

struct MakeArguments {
  io::PuzzleRequest request;
  std::string cut = "tabs";
};

int make(MakeArguments arguments) {
  io::PuzzleRequest& request = arguments.request;
  request.style = arguments.cut == "tabs" ? CutStyle::tabs : CutStyle::polygons;
  if (request.folder.empty()) request.folder = std::filesystem::path(request.picture).stem().string() + "_puzzle";
  if (!std::filesystem::path(request.folder).has_filename())  // a slash at its end
    request.folder = std::filesystem::path(request.folder).parent_path().string();
  io::Drawers drawers(io::photo_drawer_settings(1));
  const io::MadePuzzle made = io::make_puzzle(request, drawers);
  const std::string folder = io::printable_utf8(request.folder);
  std::printf("%s: %d pieces of a picture of %d x %d px\n", folder.c_str(), made.pieces, made.width_px, made.height_px);
  std::printf("next: tessera library build %s/pieces -o %s.h5 --keep-rectangles\n", folder.c_str(), folder.c_str());
  std::printf("      tessera puzzle solve %s.h5 --size %d,%d\n", folder.c_str(), made.width_px, made.height_px);
  return 0;
}

struct SolveArguments {
  io::SolvingRequest request;
  CollageArguments collage;
  bool job_only = false;
};

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 10;
  std::string text;
  for (std::size_t i = 0; i < std::min(kMost, names.size()); ++i)
    text += (i > 0 ? ", " : "") + io::printable_utf8(names[i]);
  return names.size() > kMost ? text + " and " + std::to_string(names.size() - kMost) + " others" : text;
}

/// What is not as it should be, beside pieces that are left over.
std::string doubt(const SolveArguments& arguments, const io::SolvedPuzzle& solved) {
  constexpr double kLeastCovered = 0.99;
  if (solved.gaps > kMostPuzzleGaps)
    return "there are narrow gaps between pieces: not all of them belong where they lie";
  if (arguments.request.frame_px && !solved.in_frame)
    return "what was laid does not lie in the frame, the canvas is as large as it; where pieces are missing or "
           "foreign, --scale says "
           "how large the others are";
  if (solved.left_over.empty() && solved.in_frame && solved.covered < kLeastCovered)
    return "the frame is not full: pieces are missing";
  return "";
}

void report(const SolveArguments& arguments, const io::SolvedPuzzle& solved) {
  if (!solved.left_over.empty()) {
    std::fprintf(stderr, "tessera: warning: %zu of %zu pieces found no place: %s\n", solved.left_over.size(),
                 solved.pieces, listed(solved.left_over).c_str());
  }
  if (const std::string text = doubt(arguments, solved); !text.empty())
    std::fprintf(stderr, "tessera: warning: %s\n", text.c_str());
  if (arguments.collage.quiet) return;
  std::printf("%s: %zu of %zu pieces on %d x %d px, %.2f %% of it covered, scale %.4g\n",
              io::printable_utf8(arguments.request.job).c_str(), solved.placed, solved.pieces, solved.width_px,
              solved.height_px, 100 * solved.covered, solved.scale);
  if (solved.agreement) {
    std::printf("by %s: %d of %zu right (within 2 px, 1 degree, 1 %%), %.2f px off at most\n",
                io::printable_utf8(arguments.request.truth).c_str(), solved.agreement->right, solved.pieces,
                double(solved.agreement->worst_px));
  }
  if (arguments.job_only) std::printf("next: tessera collage %s\n", io::printable_utf8(arguments.request.job).c_str());
  std::fflush(stdout);
}

/// Rank 0 alone lays the pieces and writes the job; the workers get it from there as of any collage.
int solve(SolveArguments arguments, comm::Communicator& ranks) {
  io::SolvingRequest& request = arguments.request;
  if (request.job.empty()) request.job = std::filesystem::path(request.library).stem().string() + ".toml";
  if (request.scale && std::isnan(*request.scale)) throw InputError("--scale: found nan, allowed: a number");
  arguments.collage.job = request.job;
  if (ranks.rank() == 0 && !arguments.collage.quiet) {
    std::printf("laying pieces by their outlines; hundreds take a minute\n");
    std::fflush(stdout);
  }
  if (ranks.rank() == 0) report(arguments, io::write_solved_puzzle(request));
  return arguments.job_only ? 0 : collage_exit_code(arguments.collage, ranks);
}

void add_make(CLI::App& puzzle, Command& selected) {
  const auto arguments = std::make_shared<MakeArguments>();
  io::PuzzleRequest& request = arguments->request;
  CLI::App* command = puzzle.add_subcommand("make", "Cut a picture into pieces that interlock, and mix them");
  command->footer(kMakeExamples);
  command->add_option("IMAGE", request.picture, "JPEG, PNG, TIFF, WebP or BMP")->required()->type_name("FILE");
  command->add_option("--pieces", request.pieces, "About so many, 2 to 2000")->capture_default_str();
  command->add_option("--cut", arguments->cut, "tabs, or polygons with straight sides")
      ->check(CLI::IsMember({"tabs", "polygons"}))
      ->capture_default_str();
  command->add_option("--seed", request.seed, "Another seed, another cut")->capture_default_str();
  command->add_option("--out", request.folder, "A new folder; default: <name of the image>_puzzle")->type_name("DIR");
  command->callback([arguments, &selected] { selected.run = [arguments] { return make(*arguments); }; });
}

void add_solve(CLI::App& puzzle, Command& selected) {
  const auto arguments = std::make_shared<SolveArguments>();
  io::SolvingRequest& request = arguments->request;
  CLI::App* command = puzzle.add_subcommand("solve", "Lay a puzzle's pieces beside each other as they were cut");
  command->footer(kSolveExamples);
  command->add_option("LIB", request.library, "The pieces")->required()->type_name("LIB.h5");
  command->add_option("--size", request.frame_px, "The frame, px of the canvas; default: none")
      ->delimiter(',')
      ->expected(2)
      ->check(CLI::Range(64, 20'000))
      ->type_name("W,H");
  command
      ->add_option("--scale", request.scale,
                   "px of the canvas for one px of the pieces; default: so that all of them fill the frame, or 1")
      ->check(CLI::Range(0.001, 1000.0))
      ->type_name("K");
  command
      ->add_option("--truth", request.truth, "A folder with the pieces.geojson of how they were cut: says how far off")
      ->type_name("DIR");
  command->add_option("--job", request.job, "The job file to write; default: <name of the library>.toml")
      ->type_name("FILE.toml");
  command->add_flag("--job-only", arguments->job_only, "Write the job and where the pieces lie, and run nothing");
  command->add_flag("--replace", request.replace, "Write them anew where others are there");
  add_collage_options(*command, arguments->collage);
  command->callback([arguments, &selected] {
    selected.run_on_all_ranks = [arguments](comm::Communicator& ranks) { return solve(*arguments, ranks); };
  });
}

}  // namespace

void add_puzzle_command(CLI::App& app, Command& selected) {
  CLI::App* puzzle = app.add_subcommand("puzzle", "Jigsaws: cut pictures up, lay pieces together");
  puzzle->footer(kExamples);
  puzzle->require_subcommand(1);
  add_make(*puzzle, selected);
  add_solve(*puzzle, selected);
}

}  // namespace tessera::cli
