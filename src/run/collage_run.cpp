// Rank 0 of tessera collage. lead() is the outline: it reads the input, lets compute() make the collage, and draws it.
#include "run/collage_run.h"

#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

#include "comm/stop_signals.h"
#include "comm/teams/loop_clock.h"
#include "comm/teams/rank_sites.h"
#include "core/base/count_text.h"
#include "core/base/error.h"
#include "core/base/stop.h"
#include "core/base/version.h"
#include "job/pieces/job_library.h"
#include "library/library_shapes.h"
#include "master/collage_loop.h"
#include "result/folder/folder_name.h"
#include "result/folder/result_file.h"
#include "result/rank_table.h"
#include "run/collage_checkpoints.h"
#include "run/collage_input.h"
#include "run/collage_journal.h"
#include "run/collage_publishing.h"
#include "run/collage_worker.h"
#include "run/command_line.h"
#include "run/early_result.h"
#include "run/loop_matchers.h"
#include "run/messages/collage_warnings.h"
#include "run/problem_exchange.h"
#include "run/program_identity.h"
#include "run/progress/collage_progress.h"
#include "run/progress/time_limit.h"
#include "run/result_drawing_run.h"
#include "run/results/report_run.h"
#include "run/run_warnings.h"
#include "run/unplaced_pieces.h"
#include "terminal/terminal.h"
#include "text/utc_time.h"

namespace tessera {
namespace {

void say(const CollageArguments& arguments, const std::string& text) {
  if (!arguments.quiet) print_lines(text + "\n");
}

/// A run of rank 0 that has something to compute.
struct MasterRun {
  const CollageArguments& arguments;
  const CollageInput& input;
  const TimeLimit& limit;
  comm::Communicator& ranks;
  std::shared_ptr<CollageJournal> journal;  // the ranks' watch shares it
};

/// The outcome of the loop.
struct LoopOutcome {
  master::CollageResult result;
  RankStatistics times;
};

/// The times of all ranks. Empty where mpirun is ending the job or a question was given up: workers may be gone or busy.
RankStatistics times_of(comm::LoopClock& clock, const master::CollageResult& result) {
  if (comm::stop_signalled() || result.matcher_interrupted) return {};
  try {
    return clock.stop(result.own_work);
  } catch (const Interrupted&) {
    return {};
  }
}

RunRecord record_of(const CollageInput& input) {
  RunRecord record;
  record.version = program_version();
  record.commit = program_commit();
  record.command_line = own_command_line();
  record.job_file = std::filesystem::absolute(input.problem.job().path).string();
  record.library_file = library_text(input.problem.job());
  record.library_digest = input.origin.library_digest;
  record.started_utc = utc_now();
  return record;
}

/// Seconds that leaving takes. This rank waits two seconds for a rank that does not report its end (rank_program.cpp); then
/// mpirun kills that rank, which takes two more.
double shutdown_s(const comm::Communicator& ranks) { return ranks.size() > 1 ? 4 : 0; }

void note_beginning(const MasterRun& run) {
  warn_of_problem(run.arguments, run.input, *run.journal);
  run.journal->warn(short_limit_warning(run.limit.seconds(), shutdown_s(run.ranks)));
  if (run.input.from) run.journal->resumed(*run.input.from);
}

/// Makes all waits of this rank obey signals, the time limit and the watch over the workers.
StopQuestion watch_waits(const MasterRun& run) {
  comm::install_stop_handlers();
  const StopQuestion shall_stop = [limit = run.limit,
                                   shutdown_s = shutdown_s(run.ranks)]() -> std::optional<StopReason> {
    if (comm::stop_signalled()) return StopReason::signal;
    return limit.must_end_round(shutdown_s) ? std::optional(StopReason::time_limit) : std::nullopt;
  };
  run.ranks.interrupt_waits_when(shall_stop);
  run.ranks.watch_workers(run.input.problem.job().comm.silence_s, [journal = run.journal](const std::string& line) {
    journal->warn(line + " (comm.silence_s): the run ends here");
  });
  return shall_stop;
}

/// Makes the matchers, and installs our stop handlers again: LLVM installs its own with the first kernel. LLVM's handlers
/// reset themselves when they are called, so a second signal at that moment, as timeout(1) sends it, would end the process.
LoopMatchers signal_safe_matchers(const MasterRun& run, ShapeSource& shapes, const StopQuestion& shall_stop) {
  LoopMatchers matchers = gather_matchers(run.ranks, run.input.problem, shapes, shall_stop);
  comm::install_stop_handlers();
  return matchers;
}

LoopOutcome run_loop(const MasterRun& run, LoopMatchers& matchers, ShapeSource& shapes,
                     master::CheckpointKeeper& checkpoints) {
  const CollageInput& input = run.input;
  const CheckpointState* from = input.from ? &*input.from : nullptr;
  comm::LoopClock clock(run.ranks);
  if (from) say(run.arguments, "going on from " + from->name + ", " + count_text(from->placements.size(), "piece"));
  const CollageSettings& settings = input.problem.settings();
  CollageProgress progress(settings, run.arguments.quiet, run.limit);
  master::CollageResult result = master::make_collage(input.problem.canvas(), settings, *matchers.matcher, shapes,
                                                      progress, {from, &checkpoints}, matchers.replacer.get());
  result.statistics.last_tenth = progress.history().gained_in_last_tenth(result.statistics.total_s);
  constexpr std::size_t kMostMoments = 300;
  run.journal->set_growth(progress.history().growth(kMostMoments));
  RankStatistics times = times_of(clock, result);
  return {std::move(result), std::move(times)};
}

/// Warns of what the result lacks, and writes all of the result but its pictures.
CollageEnd conclude(const MasterRun& run, const LoopOutcome& loop, const CollageCheckpoints& checkpoints) {
  const CollageInput& input = run.input;
  const master::CollageResult& result = loop.result;
  const std::vector<MissingShape> missing = missing_shapes(input.problem, result);
  warn_of_result(run.arguments, input, result, missing, *run.journal);
  run.journal->keep_warning(checkpoints.warning());
  const RunRecord& record = run.journal->ended(result.statistics.stopped_by.value(), result.placements.size());
  if (leaves_older_result(input, result)) {
    checkpoints.require_one();
    return CollageEnd::nothing_placed;
  }
  const std::string card = publish(input, result, missing, loop.times, record, checkpoints) + ranks_text(loop.times);
  say(run.arguments, card + "\nwritten to " + input.folder);
  if (result.unfinished) return CollageEnd::unfinished;
  return missing.empty() && !result.placements.empty() ? CollageEnd::finished : CollageEnd::incomplete;
}

/// Makes the result without its pictures, from the empty canvas or a checkpoint.
CollageEnd compute(const MasterRun& run) {
  const CollageInput& input = run.input;
  note_beginning(run);
  const StopQuestion shall_stop = watch_waits(run);
  announce_problem(run.ranks, program_identity(), input.problem, input.origin.library_digest);
  LibraryShapes shapes(input.problem.library());
  LoopMatchers matchers = signal_safe_matchers(run, shapes, shall_stop);
  run.journal->set_rank_sites(comm::gather_sites(run.ranks, matchers.site));
  if (input.start == Start::restart) input.checkpoints.remove();
  CollageCheckpoints checkpoints(input.checkpoints, input.origin, input.problem.job().checkpoint.every_s);
  EarlyResult early(input, record_of(input), checkpoints);
  master::CheckpointKeeper& keeper = run.arguments.early ? static_cast<master::CheckpointKeeper&>(early) : checkpoints;
  const LoopOutcome loop = run_loop(run, matchers, shapes, keeper);
  return conclude(run, loop, checkpoints);
}

bool wants_report(const CollageInput& input) { return input.problem.job().output.report; }

/// Draws the pictures of a finished collage. False: interrupted.
bool draw_pictures(const CollageArguments& arguments, const CollageInput& input, const TimeLimit& limit,
                   comm::Communicator& ranks) {
  comm::install_stop_handlers();
  PictureRequest pictures;
  pictures.svg = pictures.png = true;
  pictures.library = library_paths(input.problem.job());
  try {
    const bool drawn = draw(input.folder, pictures, arguments.quiet, [&]() -> std::optional<StopReason> {
      if (comm::stop_signalled()) return StopReason::signal;
      return limit.must_end_drawing(shutdown_s(ranks)) ? std::optional(StopReason::time_limit) : std::nullopt;
    });
    if (!drawn) ranks.end_soon();
    if (drawn && wants_report(input)) write_result_report(input.folder);
    return drawn;
  } catch (const EnvironmentError& error) {
    throw EnvironmentError(std::string(error.what()) + "; the collage is finished, tessera draw " + input.folder +
                           " makes its pictures");
  }
}

CollageEnd lead(const CollageArguments& arguments, comm::Communicator& ranks) {
  const TimeLimit limit(time_limit_s(arguments.time_limit, std::getenv("SLURM_JOB_END_TIME"),
                                     double(std::time(nullptr)), shutdown_s(ranks)));
  const CollageInput input(arguments);
  CollageEnd end = CollageEnd::finished;
  if (input.finished) {
    say(arguments, input.folder + ": finished before, nothing is left to compute");
    end = end_of_finished(input.earlier.whole->manifest);
    print_warning(incomplete_warning(input.folder, input.earlier.whole->manifest));
    if (input.earlier.whole->drawn) {
      if (wants_report(input) && !is_in_result(input.folder, kReportName)) write_result_report(input.folder);
      return end;
    }
  } else {
    const auto journal = std::make_shared<CollageJournal>(input.folder, record_of(input));
    end = journal->watch([&] { return compute({arguments, input, limit, ranks, journal}); });
    if (!is_finished(end)) return end;
  }
  return draw_pictures(arguments, input, limit, ranks) ? end : CollageEnd::not_drawn;
}

}  // namespace

CollageEnd end_of_finished(const ResultManifest& manifest) {
  return manifest.complete() ? CollageEnd::finished : CollageEnd::incomplete;
}

CollageEnd run_collage(const CollageArguments& arguments, comm::Communicator& ranks) {
  if (ranks.rank() != 0) run_collage_worker(ranks);  // never returns: a worker leaves by JobEnded
  try {
    return lead(arguments, ranks);
  } catch (const Interrupted&) {  // before the first round: the folder is unchanged
    return CollageEnd::not_begun;
  }
}

}  // namespace tessera
