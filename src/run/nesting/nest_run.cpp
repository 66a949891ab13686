#include "run/nesting/nest_run.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "comm/stop_signals.h"
#include "core/base/count_text.h"
#include "core/base/error.h"
#include "core/base/stop.h"
#include "core/base/stopwatch.h"
#include "products/nesting/layout/nest_check.h"
#include "products/nesting/nest_folder.h"
#include "run/nesting/nest_chains.h"
#include "run/nesting/nest_fit.h"
#include "run/nesting/nest_problem_arguments.h"
#include "run/nesting/nest_stop.h"
#include "terminal/exit_codes.h"
#include "terminal/progress_bar.h"
#include "terminal/terminal.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

std::string shown_folder(const NestArguments& arguments) { return printable_utf8(arguments.folder); }

double area_of(const NestProblem& problem) {
  double area = 0;
  for (const NestItem& item : problem.items) area += std::abs(signed_area(item.outline)) * item.demand;
  return area;
}

/// About how many sheets there will be.
double sheets_to_write(const NestProblem& problem) {
  constexpr double kDensity = 0.6;
  if (!std::isfinite(problem.length)) return 1;
  double pieces = 0;
  for (const NestItem& item : problem.items) pieces += item.demand;
  return std::min(pieces, area_of(problem) / (problem.height * problem.length) / kDensity);
}

/// Reserves time for the files of the layout, where the search has a limit.
void leave_time_to_write(const NestRun& run, const NestFolder& folder, NestStop& stop) {
  constexpr double kOfPoint_s = 2e-6, kOfSheet_s = 1e-3, kOfPicture_s = 0.15;
  if (!stop.has_limit()) return;
  const double sheets = sheets_to_write(run.problem);
  const double computing_s = kOfPoint_s * double(points_to_cut(run.input)) + kOfSheet_s * sheets;
  stop.leave_time_for(computing_s + folder.seconds_to_write(!run.input.library.empty(), sheets), kOfPicture_s * sheets);
}

/// Shows the density so far, how far the search is, and when it will be over.
class SearchProgress {
 public:
  SearchProgress(const NestProblem& problem, const NestStop& stop)
      : problem_(problem),
        stop_(stop),
        area_(area_of(problem)) {}

  void show(double done, const NestLayout& best) {
    const std::size_t parts = std::size_t(done * kParts);
    const double limit_s = std::max(0.0, stop_.search_left_s());
    std::optional<double> left_s = time_left_s(parts, kParts, watch_.seconds());
    if (std::isfinite(limit_s)) left_s = std::min(left_s.value_or(limit_s), limit_s);
    bar_.update(parts, note(best), left_s);
  }

 private:
  static constexpr std::size_t kParts = 1000;

  std::string note(const NestLayout& best) const {
    char text[80];
    if (std::isfinite(problem_.length))
      std::snprintf(text, sizeof text, "%s", count_text(std::size_t(best.sheets), "sheet").c_str());
    else
      std::snprintf(text, sizeof text, "%.1f %% dense, %.6g mm long",
                    100 * area_ / (problem_.height * best.used_length), best.used_length);
    return text;
  }

  const NestProblem& problem_;
  const NestStop& stop_;
  double area_;  // of all pieces
  Stopwatch watch_;
  ProgressBar bar_{"nesting", kParts};
};

/// Throws Interrupted where there is a reason to stop.
void end_if(std::optional<StopReason> reason) {
  if (reason) throw Interrupted{*reason};
}

/// Shows how many files are written.
class FileProgress {
 public:
  FileProgress(const char* what, bool quiet) : what_(what), quiet_(quiet) {}

  void show(std::size_t done, std::size_t all) {
    if (quiet_) return;
    if (!bar_) bar_.emplace(what_, all);
    bar_->update(done, std::to_string(done) + " of " + count_text(all, "file"));
  }

 private:
  const char* what_;
  bool quiet_;
  std::optional<ProgressBar> bar_;
};

NestOutcome searched(const NestArguments& arguments, const NestProblem& problem, NestStop& stop,
                     comm::Communicator& ranks) {
  std::optional<SearchProgress> progress;
  if (!arguments.quiet) progress.emplace(problem, stop);
  ranks.watch_workers(arguments.silence_s,
                      [](const std::string& line) { print_warning(line + " (--silence-s): the search ends here"); });
  return best_nesting(
      ranks, problem, *nest_effort(arguments.effort), arguments.seed,
      [&](double done, const NestLayout& best) {
        if (progress) progress->show(done, best);
      },
      [&] { return stop.search_over(); });
}

int left_over(const NestRun& run) {
  int count = 0;
  for (const int of_item : run.layout.left_over) count += of_item;
  return count;
}

void warn_of_left_over(const NestRun& run) {
  std::string names;
  for (std::size_t i = 0; i < run.layout.left_over.size(); ++i) {
    if (run.layout.left_over[i] > 0) names += (names.empty() ? "" : ", ") + run.input.sources[i].drawing.name;
  }
  if (names.empty()) return;
  print_warning(std::to_string(left_over(run)) + " of " + count_text(std::size_t(wanted_pieces(run)), "piece") +
                " found no place: " + cut_utf8(names, 200));
}

/// The warning that the instance has fewer sheets than the layout; empty: it has enough.
std::string stock_warning(const NestArguments& arguments, const NestRun& run) {
  const std::optional<NestBin> sheet = sheet_of(arguments, run.input);
  return sheet ? stock_text(*sheet, run.layout.sheets) : "";
}

/// Reports the layout. `drawn`: how many sheets have a picture. The last line on stderr says how to go on.
void report(const NestArguments& arguments, const NestRun& run, int drawn) {
  warn_of_left_over(run);
  if (const std::string stock = stock_warning(arguments, run); !stock.empty()) print_warning(stock);
  if (drawn < run.layout.sheets) {
    print_warning(shown_folder(arguments) + ": drew " + std::to_string(drawn) + " of " +
                  count_text(std::size_t(run.layout.sheets), "layout picture") +
                  " (.png); all other files are there; the same command starts again");
  }
  if (run.stopped_by) {
    print_warning("stopped by " + stopped_by_text(run) +
                  ": the best layout so far was written; the same command may give another one");
  }
  if (arguments.quiet) return;
  print_lines(nest_card_text(run));
  print_line("%s: layout.json, and the sheets as .svg, .dxf and .png", shown_folder(arguments).c_str());
  if (!run.input.library.empty()) {
    print_line("next: tessera collage %s/layout%s.toml", shown_folder(arguments).c_str(),
               run.layout.sheets > 1 ? "_1" : "");
  }
}

/// Draws the pictures and returns their number. They are for people: a layout is whole without them.
int draw(const NestArguments& arguments, const NestRun& run, NestStop& stop, NestFolder& folder) {
  FileProgress progress("drawing", arguments.quiet);
  int drawn = 0;
  try {
    folder.draw(run, [&](std::size_t done, std::size_t all) {
      drawn = int(done);
      end_if(stop.must_end_drawing(done));
      progress.show(done, all);
    });
    return run.layout.sheets;
  } catch (const Interrupted&) {
    return drawn;
  }
}

/// Whether the search ended in a way that the user did not ask for.
bool interrupts(std::optional<StopReason> stopped_by, const NestStop& stop) {
  return stopped_by && !(stopped_by == StopReason::time_limit && stop.was_asked_for());
}

void check(const NestRun& run, NestStop& stop) {
  const std::string fault = nest_fault(run.problem, run.layout, [&] { end_if(stop.writing_over()); });
  if (!fault.empty()) throw std::logic_error("nesting: " + fault);
}

/// Writes the layout and returns the exit code.
int write(const NestArguments& arguments, const NestRun& run, NestStop& stop, NestFolder& folder) {
  check(run, stop);
  FileProgress progress("writing", arguments.quiet);
  folder.write(run, [&](std::size_t done, std::size_t all) {
    end_if(stop.writing_over());
    progress.show(done, all);
  });
  const int drawn = draw(arguments, run, stop, folder);
  report(arguments, run, drawn);
  if (interrupts(run.stopped_by, stop) || drawn < run.layout.sheets) return kUnfinishedExitCode;
  const bool lacks_something = left_over(run) > 0 || !stock_warning(arguments, run).empty();
  return lacks_something ? kIncompleteExitCode : kDoneExitCode;
}

int nest(NestArguments& arguments, comm::Communicator& ranks) {
  NestStop stop(arguments.time_limit, ranks.size() > 1);
  check_arguments(arguments);
  NestRun run;
  run.input = read_nest_input(arguments.input, {.px_per_inch = arguments.px_per_inch, .left_out = arguments.left_out});
  set_demands(run.input, demands_of(arguments.demands));
  run.problem = problem_of(arguments, run.input);
  run.effort = arguments.effort;
  run.seed = arguments.seed;
  if (arguments.folder.empty()) arguments.folder = "out/" + run.input.name;
  for (const std::string& note : run.input.notes) print_warning(note);
  const std::string too_large = too_large_text(run.input, run.problem, printable_utf8(arguments.input));
  if (!too_large.empty()) print_warning(too_large);
  comm::install_stop_handlers();
  NestFolder folder(arguments.folder);
  leave_time_to_write(run, folder, stop);
  const Stopwatch watch;
  NestOutcome found = searched(arguments, run.problem, stop, ranks);
  run.layout = std::move(found.layout);
  run.stopped_by = found.stopped_by;
  run.seconds = watch.seconds();
  if (run.stopped_by) ranks.end_soon();
  if (!run.layout.pieces.empty()) return write(arguments, run, stop, folder);
  if (run.stopped_by) throw Interrupted{*run.stopped_by};
  throw std::logic_error("nesting: no piece has a place, though some fit");
}

}  // namespace

int nest_on_all_ranks(NestArguments arguments, comm::Communicator& ranks) {
  if (ranks.rank() != 0) work_on_nesting(ranks, arguments.silence_s);  // never returns: a worker leaves by JobEnded
  try {
    return nest(arguments, ranks);
  } catch (const Interrupted&) {
    ranks.end_soon();
    print_message("unfinished, nothing was written, and an earlier layout is as it was: the same command starts again");
    return kUnfinishedExitCode;
  }
}

}  // namespace tessera
