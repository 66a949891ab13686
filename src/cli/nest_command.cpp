#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/collage_run.h"
#include "cli/commands.h"
#include "cli/list_option.h"
#include "cli/nest_chains.h"
#include "cli/time_limit.h"
#include "comm/stop_signals.h"
#include "core/base/error.h"
#include "core/base/interrupted.h"
#include "core/base/stopwatch.h"
#include "core/nesting/nest_check.h"
#include "io/nesting/nest_input.h"
#include "io/nesting/nest_result.h"
#include "io/utf8_text.h"

namespace tessera::cli {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  tessera nest parts.svg --strip 600                      the shortest strip, 600 mm high: out/parts\n"
    "  tessera nest parts.dxf --sheet 1000,500 --spacing 2     as few sheets as it takes, 2 mm between pieces\n"
    "  tessera nest swim.json --effort best                    an instance with its own strip, demands and angles\n"
    "  tessera nest parts/ --strip 600 --demand 'wheel*=4' --demand lid=2 --angles 0,180\n"
    "  tessera nest animals.h5 --sheet 420,297                 and a job that tessera collage draws\n"
    "INPUT: an instance of sparrow or jagua-rs (.json), an SVG, a DXF, a folder of these two, or a library. Pieces "
    "keep\n"
    "their sizes; each closed outline is one, with the holes in it. DIR has layout.svg and .dxf in mm for the cutter,\n"
    "layout.png to look at, layout.json, card.txt. Pieces that find no place are named, and the exit code is 0 all the "
    "same.";

struct NestArguments {
  std::string input;
  std::optional<double> strip_mm;
  std::vector<double> sheet_mm;
  std::vector<double> angles_deg;
  std::vector<std::string> demands;
  double spacing_mm = 0;
  std::string effort = "good";
  std::uint64_t seed = 1;
  std::string folder;
  bool quiet = false;
  std::optional<std::string> time_limit;
};

constexpr double kLeast_mm = 1e-3;
/// Each shape is kept at each of its angles: some 300 MB.
constexpr std::size_t kMostTurnedPoints = 10'000'000;

void check_length(const std::string& option, double mm, double least) {
  if (mm >= least && mm <= io::kFarthest_mm) return;
  char text[96];
  std::snprintf(text, sizeof text, ": found %g, allowed: a number from %g to %g mm", mm, least, io::kFarthest_mm);
  throw InputError(option + text);
}

/// "name=3", "name" being a pattern.
std::vector<std::pair<std::string, int>> demands_of(const std::vector<std::string>& texts) {
  std::vector<std::pair<std::string, int>> demands;
  for (const std::string& text : texts) {
    const std::size_t sign = text.rfind('=');
    const std::string digits = sign == std::string::npos ? "" : text.substr(sign + 1);
    const bool number =
        !digits.empty() && digits.size() <= 4 && digits.find_first_not_of("0123456789") == std::string::npos;
    if (!number || sign == 0 || std::stoi(digits) > kMostNestedPieces) {
      throw InputError("--demand " + io::printable_utf8(text) + ": allowed: NAME=COUNT, 0 to " +
                       std::to_string(kMostNestedPieces));
    }
    demands.emplace_back(text.substr(0, sign), std::stoi(digits));
  }
  return demands;
}

std::vector<double> angles_of(const NestArguments& arguments, const io::NestSource& source) {
  static const std::vector<double> kQuarters = {0, 90, 180, 270};
  if (!arguments.angles_deg.empty()) return arguments.angles_deg;
  return source.angles_deg.empty() ? kQuarters : source.angles_deg;
}

void check_arguments(const NestArguments& arguments) {
  constexpr double kMostTurn_deg = 3600;
  if (arguments.strip_mm && !arguments.sheet_mm.empty()) throw InputError("--strip and --sheet: allowed: one of them");
  if (arguments.strip_mm) check_length("--strip", *arguments.strip_mm, kLeast_mm);
  for (const double side : arguments.sheet_mm) check_length("--sheet", side, kLeast_mm);
  check_length("--spacing", arguments.spacing_mm, 0);
  for (const double angle : arguments.angles_deg) {
    if (!(std::abs(angle) <= kMostTurn_deg)) throw InputError("--angles: allowed: numbers from -3600 to 3600 degrees");
  }
  if (arguments.angles_deg.size() > 360) throw InputError("--angles: allowed: 360 of them or fewer");
}

/// What is smaller than the check can see has no place in a layout.
void check_size(const NestArguments& arguments, const io::NestDrawing& drawing, double height_mm) {
  const NestBox box = box_of(drawing.outline);
  const double size_mm = std::max(box.width(), box.height());
  if (size_mm >= kNestTolerance * height_mm) return;
  char text[96];
  std::snprintf(text, sizeof text, ": found a size of %g mm, allowed: %g or more, a millionth of the height", size_mm,
                kNestTolerance * height_mm);
  throw InputError(io::printable_utf8(arguments.input) + ": " + drawing.name + text);
}

NestProblem problem_of(const NestArguments& arguments, const io::NestInput& input) {
  NestProblem problem;
  problem.spacing = arguments.spacing_mm;
  problem.height =
      !arguments.sheet_mm.empty() ? arguments.sheet_mm[1] : arguments.strip_mm.value_or(input.strip_height);
  if (!arguments.sheet_mm.empty()) problem.length = arguments.sheet_mm[0];
  if (!(problem.height > 0)) {
    throw InputError(io::printable_utf8(arguments.input) +
                     ": how large is the material? allowed: --strip H, or --sheet W,H, in mm");
  }
  std::size_t pieces = 0, points = 0;
  for (const io::NestSource& source : input.sources) {
    check_size(arguments, source.drawing, problem.height);
    problem.items.push_back({source.drawing.outline, angles_of(arguments, source), source.demand});
    pieces += std::size_t(source.demand);
    points += source.drawing.outline.size() * problem.items.back().angles_deg.size();
  }
  if (pieces < 1 || pieces > kMostNestedPieces) {
    throw InputError(io::printable_utf8(arguments.input) + ": found " + std::to_string(pieces) +
                     " pieces in all, allowed: 1 to " + std::to_string(kMostNestedPieces));
  }
  if (points > kMostTurnedPoints) {
    throw InputError(io::printable_utf8(arguments.input) + ": found " + std::to_string(points) +
                     " points of all shapes at all angles, allowed: " + std::to_string(kMostTurnedPoints) +
                     " (--angles)");
  }
  return problem;
}

/// Says now and then how dense it is by now.
NestProgress progress_of(const NestArguments& arguments, const NestProblem& problem) {
  double area = 0;
  for (const NestItem& item : problem.items) area += std::abs(signed_area(item.outline)) * item.demand;
  const bool strip = !std::isfinite(problem.length);
  return [=, said = 0.0](int sheet, double length) mutable {
    constexpr double kStep = 0.005;
    if (arguments.quiet) return;
    const double now = strip ? area / (problem.height * length) : double(sheet);
    if (now < said + (strip ? kStep : 1)) return;
    said = now;
    if (strip)
      std::fprintf(stderr, "%.1f %% dense, %.6g mm long\n", 100 * now, length);
    else
      std::fprintf(stderr, "sheet %d is full\n", sheet);
  };
}

void report(const NestArguments& arguments, const io::NestRun& run, const std::string& card) {
  std::string left;
  int count = 0;
  for (std::size_t i = 0; i < run.layout.left_over.size(); ++i) {
    if (run.layout.left_over[i] == 0) continue;
    left += (left.empty() ? "" : ", ") + run.input.sources[i].drawing.name;
    count += run.layout.left_over[i];
  }
  if (count > 0) {
    std::fprintf(stderr, "tessera: warning: %d of %d pieces found no place: %s\n", count, io::wanted_pieces(run),
                 io::cut_utf8(left, 200).c_str());
  }
  if (arguments.quiet) return;
  std::printf("%s", card.c_str());
  std::printf("%s: layout.json, and the sheets as .svg, .dxf and .png\n", io::printable_utf8(arguments.folder).c_str());
  if (!run.input.library.empty()) {
    std::printf("next: tessera collage %s/layout%s.toml\n", io::printable_utf8(arguments.folder).c_str(),
                run.layout.sheets > 1 ? "_1" : "");
  }
}

/// A signal or the limit: asked by any thread.
std::function<const char*()> stop_reason_of(const NestArguments& arguments, const comm::Communicator& ranks) {
  const double leaving_s = ranks.size() > 1 ? 4 : 0;  // of several ranks, as of a collage
  const double limit_s =
      time_limit_s(arguments.time_limit, std::getenv("SLURM_JOB_END_TIME"), double(std::time(nullptr)), leaving_s);
  comm::install_stop_handlers();
  return [limit = TimeLimit(limit_s), leaving_s]() -> const char* {
    if (comm::stop_signalled()) return "signal";
    return limit.round_over(leaving_s) ? "time_limit" : nullptr;
  };
}

int nest(NestArguments& arguments, comm::Communicator& ranks) {
  check_arguments(arguments);
  io::NestRun run;
  run.input = io::read_nest_input(arguments.input);
  io::set_demands(run.input, demands_of(arguments.demands));
  run.problem = problem_of(arguments, run.input);
  run.effort = arguments.effort;
  run.seed = arguments.seed;
  if (arguments.folder.empty()) arguments.folder = "out/" + run.input.name;
  io::check_nest_folder(arguments.folder);
  for (const std::string& note : run.input.notes) std::fprintf(stderr, "tessera: warning: %s\n", note.c_str());
  const auto stop_reason = stop_reason_of(arguments, ranks);
  const Stopwatch watch;
  run.layout = best_nesting(ranks, run.problem, *nest_effort(arguments.effort), arguments.seed,
                            progress_of(arguments, run.problem), stop_reason);
  run.seconds = watch.seconds();
  if (run.layout.pieces.empty()) {
    throw InputError(io::printable_utf8(arguments.input) + ": none of its pieces fits onto " +
                     (arguments.sheet_mm.empty() ? "the strip" : "the sheet") + " at the angles allowed");
  }
  if (const std::string fault = nest_fault(run.problem, run.layout); !fault.empty())
    throw std::logic_error("nesting: " + fault);
  report(arguments, run, io::write_nest_result(run, arguments.folder));
  return 0;
}

int nest_on_all_ranks(NestArguments arguments, comm::Communicator& ranks) {
  if (ranks.rank() != 0) {
    work_on_nesting(ranks);
    return 0;
  }
  try {
    return nest(arguments, ranks);
  } catch (const Interrupted&) {
    ranks.hurry();
    std::fprintf(stderr, "tessera: unfinished, nothing was written: the same command starts again\n");
    return kUnfinishedExitCode;
  }
}

}  // namespace

void add_nest_command(CLI::App& app, Command& selected) {
  const auto arguments = std::make_shared<NestArguments>();
  CLI::App* command = app.add_subcommand("nest", "Lay shapes of fixed sizes densely on a strip or on sheets");
  command->footer(kExamples);
  command->add_option("INPUT", arguments->input, "What is laid")->required()->type_name("PATH");
  command
      ->add_option("--strip", arguments->strip_mm,
                   "A strip of that height, as short as it can be; default: the instance's")
      ->type_name("MM");
  add_list_option(*command, "--sheet", arguments->sheet_mm, "Sheets of that size, as few as are needed",
                  {.type_name = "W,H", .count = 2});
  add_list_option(*command, "--angles", arguments->angles_deg,
                  "By which pieces may be turned, degrees; default: the instance's, or 0,90,180,270",
                  {.type_name = "DEG,..."});
  command
      ->add_option("--demand", arguments->demands,
                   "How many of the shapes of that name, which may have * and ?; default: 1, or the instance's")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name("NAME=COUNT");
  command->add_option("--spacing", arguments->spacing_mm, "Least distance between pieces, mm")->capture_default_str();
  command
      ->add_option(
          "--effort", arguments->effort,
          "Seconds, half a minute, or minutes for 50 simple pieces on two cores; draft and good are two searches, best "
          "is four: more cores do not help")
      ->check(CLI::IsMember({"draft", "good", "best"}))
      ->capture_default_str();
  command->add_option("--seed", arguments->seed, "Another seed, another layout")->capture_default_str();
  command->add_option("--out", arguments->folder, "Where the layout goes; default: out/<name of the input>")
      ->type_name("DIR");
  command->add_flag("--quiet", arguments->quiet, "Warnings and errors only");
  command
      ->add_option("--time-limit", arguments->time_limit, "End by then, unfinished; default: the end of the Slurm job")
      ->type_name("LIMIT");
  command->callback([arguments, &selected] {
    selected.run_on_all_ranks = [arguments](comm::Communicator& ranks) { return nest_on_all_ranks(*arguments, ranks); };
  });
}

}  // namespace tessera::cli
