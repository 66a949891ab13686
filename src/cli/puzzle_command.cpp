#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/collage_options.h"
#include "cli/commands.h"
#include "comm/stop_signals.h"
#include "core/base/count_text.h"
#include "core/base/error.h"
#include "core/base/stop.h"
#include "files/new_folder.h"
#include "products/puzzle/laying/puzzle_solver.h"
#include "products/puzzle/puzzle_making.h"
#include "products/puzzle/puzzle_solving.h"
#include "products/puzzle/solving_progress.h"
#include "program/list_option.h"
#include "run/job_output.h"
#include "run/messages/first_picture_warning.h"
#include "run/progress/time_limit.h"
#include "terminal/exit_codes.h"
#include "terminal/progress_bar.h"
#include "terminal/shell_word.h"
#include "terminal/terminal.h"
#include "text/number_text.h"
#include "text/utf8_text.h"

namespace tessera::cli {
namespace {

constexpr const char* kPuzzleExamples =
    "Examples:\n"
    "  tessera puzzle make photo.jpg --pieces 36 --out jigsaw      jigsaw/pieces/piece_001.png ..., jigsaw/truth\n"
    "  tessera library build jigsaw/pieces -o jigsaw.h5 --puzzle\n"
    "  tessera puzzle solve jigsaw.h5 --size 600,400               out/jigsaw: where they belong, a photo of 3:2";

constexpr const char* kMakeExamples =
    "Examples:\n"
    "  tessera puzzle make photo.jpg --pieces 36 --out jigsaw\n"
    "  tessera puzzle make photo.jpg --pieces 18 --cut polygons --seed 3 --out shards\n"
    "  tessera puzzle make heart.svg --pieces 24                   the heart itself is cut: heart_puzzle/frame.svg\n"
    "Each piece is a PNG with transparency, turned by a random angle; pieces are numbered in a random order.\n"
    "DIR/truth/pieces.geojson says where each lay, px of the picture. With tabs there may be a few pieces more or\n"
    "fewer: rows times columns. The next commands are printed.";

constexpr const char* kSolveExamples =
    "Examples:\n"
    "  tessera puzzle solve jigsaw.h5 --size 600,400               pieces of any scale fill a frame, of the photo's "
    "shape\n"
    "  tessera puzzle solve jigsaw.h5 --size 600,400 --scale 1     they are known to be as large as they were drawn\n"
    "  tessera puzzle solve heart.h5 --frame heart.svg             a frame of any outline\n"
    "  tessera puzzle solve jigsaw.h5                              no frame: the canvas gets the size of the solution\n"
    "  tessera puzzle solve jigsaw.h5 --size 600,400 --truth jigsaw/truth      how far the solution is off\n"
    "LIB.h5 holds each piece once, all in the same scale: as large as their pictures. Pieces are matched by their "
    "outlines\n"
    "and by the pictures on both sides; they need corners. A frame may come out upside down. jigsaw_pieces.geojson "
    "says\n"
    "where the pieces lie. jigsaw.toml is a job that shows it; it then runs as with tessera collage. Nothing is laid "
    "beyond\n"
    "a frame. Pieces without a place are named, the others are laid, and the exit code is 3.";

const std::map<std::string, CutStyle> kCuts = {
    {"tabs", CutStyle::tabs}, {"polygons", CutStyle::polygons}, {"rectangles", CutStyle::rectangles}};

struct MakeArguments {
  PuzzleRequest request;
  std::string folder;
  std::string cut = "tabs";
};

/// The folder without a slash at its end.
std::string folder_of(const MakeArguments& arguments) {
  if (arguments.folder.empty()) return std::filesystem::path(arguments.request.picture).stem().string() + "_puzzle";
  const std::filesystem::path folder = arguments.folder;
  return folder.has_filename() ? arguments.folder : folder.parent_path().string();
}

int make(MakeArguments arguments) {
  PuzzleRequest& request = arguments.request;
  request.style = kCuts.at(arguments.cut);
  const std::string out = folder_of(arguments);
  NewFolder new_folder(out);
  Drawers drawers(photo_drawer_settings(1));
  const MadePuzzle made = make_puzzle(request, drawers);
  print_warning(first_picture_warning(std::vector{request.picture}));
  try {
    const comm::StopDelay delay;  // until here a signal ends the command at once
    new_folder.write(made.files, stop_check(comm::stop_asked_by_signal));
  } catch (const Interrupted&) {
    return kUnfinishedExitCode;
  }
  const std::string folder = printable_utf8(out);
  print_line("%s: %s of a picture of %d x %d px", folder.c_str(), count_text(std::size_t(made.pieces), "piece").c_str(),
             made.width_px, made.height_px);
  const std::string library = shell_word(out + ".h5");
  const std::string frame = made.frame.empty() ? "" : " --frame " + shell_word(out + "/" + made.frame);
  print_line("next: tessera library build %s -o %s --puzzle", shell_word(out + "/pieces").c_str(), library.c_str());
  print_line("      tessera puzzle solve %s%s --size %d,%d", library.c_str(), frame.c_str(), made.width_px,
             made.height_px);
  return kDoneExitCode;
}

struct SolveArguments {
  SolvingRequest request;
  CollageArguments collage;
  bool job_only = false;
};

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 10;
  std::string text;
  for (std::size_t i = 0; i < std::min(kMost, names.size()); ++i)
    text += (i > 0 ? ", " : "") + printable_utf8(names[i]);
  return names.size() > kMost ? text + " and " + count_text(names.size() - kMost, "other") : text;
}

bool has_frame(const SolveArguments& arguments) {
  return arguments.request.frame_px || !arguments.request.frame_file.empty();
}

/// The size of all pieces laid without a frame, and the option that gives the frame that size.
std::string loose_size(const SolvedPuzzle& solved) {
  const std::string width = std::to_string(solved.loose_width_px), height = std::to_string(solved.loose_height_px);
  return width + " x " + height + " px (--size " + width + "," + height + ", or the same turned)";
}

/// Advice where all pieces fit each other, but not the frame.
std::string shape_advice(const SolvedPuzzle& solved) {
  return "; without a frame all of them fit each other: the frame of " + std::to_string(solved.width_px) + " x " +
         std::to_string(solved.height_px) + " px has another shape or size than the puzzle, which takes " +
         loose_size(solved);
}

/// Advice where pieces found no place; it depends on the options that were given.
std::string advice(const SolveArguments& arguments, const SolvedPuzzle& solved) {
  if (!has_frame(arguments)) return "";
  if (solved.loose_width_px > 0) return shape_advice(solved);
  const std::string shape =
      "; the frame may have another shape than the puzzle: without --size and --frame all that fits together is laid";
  if (arguments.request.scale) return shape;
  return shape + "; if pieces are missing or foreign, give the size of the others with --scale";
}

/// A warning about a doubtful solution, apart from pieces that are left over.
std::string solution_warning(const SolveArguments& arguments, const SolvedPuzzle& solved) {
  constexpr double kLeastFilled = 0.99;
  if (solved.gaps > kMostPuzzleGaps)
    return "there are narrow gaps between pieces: some may not belong where they lie, or outlines are not exact";
  if (solved.left_over.empty() && has_frame(arguments) && solved.filled < kLeastFilled)
    return "the frame is not full: pieces are missing, they are smaller than they were cut, or the frame has another "
           "shape than the puzzle" +
           (solved.loose_width_px > 0 ? ": all pieces together take " + loose_size(solved) : "");
  if (solved.undecided > 0)
    return std::to_string(solved.undecided) + " of " + count_text(solved.placed, "piece") +
           " have the same outline as others, and their pictures do not decide where they belong: some may lie in a "
           "wrong place";
  return "";
}

std::string erosion_text(double erosion_px) {
  return erosion_px > 0 ? "; they are " + fixed(erosion_px, 2) + " px smaller all round than they were cut" : "";
}

/// The distances of pieces from their right places: of correct ones, and, if some are laid elsewhere, of those as well.
std::string off_text(const PuzzleAgreement& agreement) {
  if (agreement.laid == 0) return "none of them was laid";
  const std::string right = fixed(agreement.worst_px, 2) + " px off at most";
  if (agreement.right == agreement.laid) return right;
  return "these " + right + ", the other " + std::to_string(agreement.laid - agreement.right) +
         " that were laid up to " + fixed(agreement.farthest_px, 2) + " px";
}

void report(const SolveArguments& arguments, const SolvedPuzzle& solved) {
  if (!solved.left_over.empty()) {
    print_warning(std::to_string(solved.left_over.size()) + " of " + count_text(solved.pieces, "piece") +
                  " found no place" + (has_frame(arguments) ? " in the frame" : "") + ": " + listed(solved.left_over) +
                  advice(arguments, solved));
  }
  print_warning(solution_warning(arguments, solved));
  if (!arguments.collage.quiet) {
    print_line("%s: %zu of %s on %d x %d px, %.2f %% of it covered, scale %.4g%s",
               printable_utf8(arguments.request.job).c_str(), solved.placed, count_text(solved.pieces, "piece").c_str(),
               solved.width_px, solved.height_px, 100 * solved.covered, solved.scale,
               erosion_text(solved.erosion_px).c_str());
  }
  if (solved.agreement) {  // the user asked for the comparison
    print_line("by %s: %d of %zu right (within 2 px, 1 degree, 1 %%), %s",
               printable_utf8(arguments.request.truth).c_str(), solved.agreement->right, solved.pieces,
               off_text(*solved.agreement).c_str());
  }
  if (arguments.job_only && !arguments.collage.quiet)
    print_line("next: tessera collage %s", shell_word(arguments.request.job).c_str());
  print_now();
}

/// Shows the progress of solving, and ends it at a signal or the time limit.
class SolvingWatch {
 public:
  SolvingWatch(const CollageArguments& arguments, const comm::Communicator& ranks)
      : quiet_(arguments.quiet),
        leaving_s_(ranks.size() > 1 ? kLeaving_s : 0),
        limit_(time_limit_s(arguments.time_limit, std::getenv("SLURM_JOB_END_TIME"), double(std::time(nullptr)),
                            leaving_s_)) {
    comm::install_stop_handlers();
  }

  /// Shows the progress. Throws Interrupted.
  void check_stop(const PuzzleProgress& at) {
    if (comm::stop_signalled()) throw Interrupted{StopReason::signal};
    if (limit_.must_end_round(leaving_s_)) throw Interrupted{StopReason::time_limit};
    if (quiet_) return;
    const SolvingProgress::Shown shown = progress_.see(at);
    if (!bar_ || shown.label != label_) bar_.emplace(label_ = shown.label, shown.of);
    bar_->update(shown.done, shown.note, std::nullopt);
  }

 private:
  static constexpr double kLeaving_s = 4;  // time for several ranks to leave, as in a collage

  bool quiet_;
  double leaving_s_;
  TimeLimit limit_;
  SolvingProgress progress_;
  std::string label_;  // of the progress bar
  std::optional<ProgressBar> bar_;
};

/// Solves the puzzle and writes the job. Returns the exit code of that, or of an early end.
int solve_and_report(SolveArguments& arguments, const comm::Communicator& ranks) {
  try {
    SolvingWatch watch(arguments.collage, ranks);
    arguments.request.watch = [&](const PuzzleProgress& at) { watch.check_stop(at); };
    const SolvedPuzzle solved = write_solved_puzzle(arguments.request);
    report(arguments, solved);
    return solved.left_over.empty() ? kDoneExitCode : kIncompleteExitCode;
  } catch (const Interrupted&) {
    print_message("unfinished, nothing was written: the same command starts again");
    return kUnfinishedExitCode;
  }
}

/// Solves the puzzle and writes the job, then runs the collage; for rank 0.
int solve_and_collage(SolveArguments& arguments, comm::Communicator& ranks) {
  const JobOutput output(arguments.collage, {solution_path(arguments.request.job)}, arguments.job_only);
  const int solved = solve_and_report(arguments, ranks);
  if (solved == kUnfinishedExitCode || arguments.job_only) return solved;
  comm::end_stop_handlers();  // signals set a flag again only once the collage has something to lose
  const int made = collage_exit_code(arguments.collage, ranks);
  return made == kDoneExitCode ? solved : made;
}

/// Only rank 0 lays the pieces and writes the job; it sends the job to the workers, as any collage.
int solve(SolveArguments arguments, comm::Communicator& ranks) {
  SolvingRequest& request = arguments.request;
  if (request.job.empty()) request.job = std::filesystem::path(request.library).stem().string() + ".toml";
  if (request.scale && std::isnan(*request.scale)) throw InputError("--scale: found nan, allowed: a number");
  arguments.collage.job = request.job;
  if (ranks.rank() == 0) return solve_and_collage(arguments, ranks);
  return arguments.job_only ? kDoneExitCode : collage_exit_code(arguments.collage, ranks);
}

void add_make(CLI::App& puzzle, Command& selected) {
  const auto arguments = std::make_shared<MakeArguments>();
  PuzzleRequest& request = arguments->request;
  CLI::App* command = puzzle.add_subcommand("make", "Cut a picture into pieces that interlock, and mix them");
  command->footer(kMakeExamples);
  command->add_option("IMAGE", request.picture, "JPEG, PNG, TIFF, WebP or BMP; of an SVG its silhouette is cut")
      ->required()
      ->type_name("FILE");
  command->add_option("--pieces", request.pieces, "Approximate number of pieces, 2 to 2000")->capture_default_str();
  command->add_option("--cut", arguments->cut, "tabs, polygons with straight sides, or rectangles, all alike")
      ->check(CLI::IsMember(kCuts))
      ->capture_default_str();
  command->add_option("--seed", request.seed, "Another seed, another cut")->capture_default_str();
  command->add_option("--out", arguments->folder, "A new folder; default: <name of the image>_puzzle")
      ->type_name("DIR");
  command->callback([arguments, &selected] { selected.run = [arguments] { return make(*arguments); }; });
}

void add_solve(CLI::App& puzzle, Command& selected) {
  const auto arguments = std::make_shared<SolveArguments>();
  SolvingRequest& request = arguments->request;
  CLI::App* command = puzzle.add_subcommand("solve", "Lay a puzzle's pieces beside each other as they were cut");
  command->footer(kSolveExamples);
  command->add_option("LIB", request.library, "The pieces")->required()->type_name("LIB.h5");
  add_list_option<int>(*command, "--size", [&request](std::vector<int> given) { request.frame_px = std::move(given); },
                       "The frame, px of the canvas, or the box of --frame; default: none",
                       {.type_name = "W,H", .count = 2, .value = CLI::Range(64, 20'000)});
  command
      ->add_option("--frame", request.frame_file,
                   "The frame is the silhouette in this file, like a canvas.file; without --size its size follows "
                   "from the pieces")
      ->type_name("FILE");
  command
      ->add_option(
          "--scale", request.scale,
          "px of the canvas for one px of the pieces; default: so that they reach the edges of the frame, or 1")
      ->check(CLI::Range(0.001, 1000.0))
      ->type_name("K");
  command
      ->add_option("--truth", request.truth,
                   "A folder with the pieces.geojson of the cut: reports how far the "
                   "solution is off")
      ->type_name("DIR");
  command->add_option("--job", request.job, "The job file to write; default: <name of the library>.toml")
      ->type_name("FILE.toml");
  command->add_flag("--outlines-only", request.outlines_only, "Ignore the pictures on the pieces");
  command->add_flag("--job-only", arguments->job_only, "Write the job and where the pieces lie, and run nothing");
  command->add_flag("--replace", request.replace, "Replace the files of another puzzle");
  add_collage_options(*command, arguments->collage);
  command->callback([arguments, &selected] {
    selected.run_on_all_ranks = [arguments](comm::Communicator& ranks) { return solve(*arguments, ranks); };
  });
}

}  // namespace

void add_puzzle_command(CLI::App& app, Command& selected) {
  CLI::App* puzzle = app.add_subcommand("puzzle", "Jigsaws: cut pictures up, lay pieces together");
  puzzle->footer(kPuzzleExamples);
  puzzle->require_subcommand(1);
  add_make(*puzzle, selected);
  add_solve(*puzzle, selected);
}

}  // namespace tessera::cli
