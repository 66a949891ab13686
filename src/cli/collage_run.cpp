#include "cli/collage_run.h"

#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "cli/collage_checkpoints.h"
#include "cli/collage_input.h"
#include "cli/collage_progress.h"
#include "cli/collage_publishing.h"
#include "cli/collage_warnings.h"
#include "cli/collage_worker.h"
#include "cli/result_drawing_run.h"
#include "cli/stop_signal.h"
#include "cli/time_limit.h"
#include "comm/loop_clock.h"
#include "comm/worker_team.h"
#include "io/result/finished_result.h"
#include "io/result/rank_table.h"
#include "master/collage_loop.h"
#include "master/library_shapes.h"

namespace tessera::cli {
namespace {

void say(const CollageArguments& arguments, const std::string& line) {
  if (!arguments.quiet) std::printf("%s\n", line.c_str());
}

/// Nothing where mpirun is ending the job: it may have ended workers already, who would never answer.
RankStatistics times_of(comm::LoopClock& clock, const master::CollageResult& result) {
  return stop_signalled() ? RankStatistics{} : clock.stop(result.own_work);
}

master::CollageResult run_loop(const CollageArguments& arguments, const CollageInput& input, const TimeLimit& limit,
                               Matcher& matcher, CollageCheckpoints& checkpoints) {
  const CheckpointState* from = input.from ? &*input.from : nullptr;
  if (from) say(arguments, "going on from " + from->name + ", " + std::to_string(from->placements.size()) + " pieces");
  install_stop_handlers();
  master::LibraryShapes shapes(input.library);
  CollageProgress progress(input.job.settings.stop, arguments.quiet, limit);
  return master::make_collage(input.canvas, input.job.settings, matcher, shapes, progress, {from, &checkpoints});
}

/// From the empty canvas or a checkpoint to the result without its pictures. False: unfinished.
bool compute(const CollageArguments& arguments, const CollageInput& input, const TimeLimit& limit,
             comm::Communicator& ranks) {
  send_job(ranks, input.job);
  const std::unique_ptr<Matcher> matcher =
      ranks.size() > 1 ? comm::gather_workers(ranks) : own_matcher(input.job, input.library);
  if (input.start == Start::restart) input.checkpoints.remove();
  CollageCheckpoints checkpoints(input.checkpoints, input.origin);
  comm::LoopClock clock(ranks);
  const master::CollageResult result = run_loop(arguments, input, limit, *matcher, checkpoints);
  const RankStatistics times = times_of(clock, result);
  const std::string card = publish(input, result, times, checkpoints) + io::ranks_text(times);
  say(arguments, card + "\nwritten to " + input.folder);
  print_warning(empty_result_warning(input.folder, input.job, result));
  return !result.unfinished;
}

/// The pictures of a finished collage. False: interrupted.
bool draw_pictures(const CollageArguments& arguments, const CollageInput& input, const TimeLimit& limit) {
  install_stop_handlers();
  io::DrawingRequest pictures;
  pictures.svg = pictures.png = true;
  pictures.library = input.job.library;
  return draw(input.folder, pictures, arguments.quiet, [&] { return stop_signalled() || limit.over(); });
}

CollageEnd lead(const CollageArguments& arguments, comm::Communicator& ranks) {
  const TimeLimit limit(
      time_limit_s(arguments.time_limit, std::getenv("SLURM_JOB_END_TIME"), double(std::time(nullptr))));
  const CollageInput input(arguments);
  if (input.finished) {
    say(arguments, input.folder + ": the collage is finished, nothing is left to compute");
    if (io::is_drawn(input.folder)) return CollageEnd::finished;
  } else {
    // Before it is too late, but no question: whoever edits a job and runs it again wants just that.
    print_warning(replaced_result_warning(input.folder, input.job));
    if (!compute(arguments, input, limit, ranks)) return CollageEnd::unfinished;
  }
  return draw_pictures(arguments, input, limit) ? CollageEnd::finished : CollageEnd::not_drawn;
}

}  // namespace

CollageEnd run_collage(const CollageArguments& arguments, comm::Communicator& ranks) {
  if (ranks.rank() == 0) return lead(arguments, ranks);
  run_collage_worker(ranks);
}

}  // namespace tessera::cli
