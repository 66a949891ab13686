#include "cli/collage_run.h"

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <thread>

#include "cli/collage_checkpoints.h"
#include "cli/collage_progress.h"
#include "cli/collage_warnings.h"
#include "cli/library_part.h"
#include "cli/rank_agreement.h"
#include "cli/time_limit.h"
#include "comm/heartbeat.h"
#include "comm/loop_clock.h"
#include "comm/matcher_server.h"
#include "comm/node_turn.h"
#include "comm/stop_signals.h"
#include "comm/worker_team.h"
#include "core/base/interrupted.h"
#include "core/matching/matching_context.h"
#include "io/job/canvas_file.h"
#include "io/job/job_file.h"
#include "io/job/job_library.h"
#include "io/library/shape_models.h"
#include "io/output_lock.h"
#include "io/result/collage_files.h"
#include "io/result/finished_result.h"
#include "io/result/rank_table.h"
#include "master/collage_loop.h"
#include "master/library_shapes.h"
#include "worker/device_group.h"

namespace tessera::cli {
namespace {

MatchingContext context_of(const io::Job& job, const io::LibraryFile& library) {
  return make_matching_context(job.settings, std::uint32_t(library.size()));
}

/// A worker's devices share its node with those of the other workers.
worker::DeviceShare share_node(const comm::Communicator& ranks, const io::Job& job) {
  const bool with_master = ranks.node_ranks().front() == 0;
  const int workers = ranks.local_size() - with_master;
  worker::limit_cpu_threads(int(std::thread::hardware_concurrency()) / workers);
  return {ranks.local_rank() - with_master, workers, job.devices_per_worker};
}

[[noreturn]] void work(comm::Communicator& ranks) {
  const io::Job job = receive_job(ranks, program_identity());
  const comm::Heart heart(ranks, job.comm.silence_s);
  const io::LibraryFile library = io::open_library_of(job);
  check_library(ranks, library);
  const ShapeRange part = library_part(library.size(), ranks.rank() - 1, ranks.size() - 1);
  const MatchingContext context = context_of(job, library);
  const worker::DeviceShare share = share_node(ranks, job);
  comm::first_worker_of_node_first(ranks, [&] { worker::compile_kernels(job.devices, context); });
  comm::serve(ranks, worker::make_device_matcher(job.devices, context, part, io::models_of(library, context), share,
                                           [&ranks] { ranks.look(); }));
}

/// The reason to stop within a round, or null.
using StopReason = std::function<const char*()>;

/// The whole library on this rank's devices.
std::unique_ptr<Matcher> own_matcher(const io::Job& job, const io::LibraryFile& library, const StopReason& stop_reason) {
  const MatchingContext context = context_of(job, library);
  const ShapeRange all = library_part(library.size(), 0, 1);
  return worker::make_device_matcher(job.devices, context, all, io::models_of(library, context),
                                     {.per_worker = job.devices_per_worker}, [stop_reason] {
                                       if (const char* reason = stop_reason()) throw Interrupted{reason};
                                     });
}

/// Of the shapes that were placed, all that the files need.
void add_placed_shapes(const io::LibraryFile& library, bool with_originals, io::CollageReport& report) {
  std::set<std::uint32_t> placed;
  for (const Placement& placement : report.placements) placed.insert(placement.shape);
  const io::LibraryParts parts{
      .outline = true, .field = true, .levels = 0, .artwork = true, .original = with_originals};
  for (const std::uint32_t index : placed) {
    report.shape_index.push_back(index);
    report.shapes.push_back(std::move(library.read(index, index + 1, parts).front()));
  }
}

/// Returns the text of the card.
std::string write(const std::string& folder, const io::Job& job, const Canvas& canvas, const io::LibraryFile& library,
                  const master::CollageResult& result, const RankStatistics& ranks) {
  // mpirun kills all ranks two seconds after Ctrl-C, and a time limit has little room for a picture.
  const bool quick = result.unfinished || comm::stop_signalled();
  io::CollageReport report;
  report.job = &job;
  report.canvas = &canvas;
  report.placements = result.placements;
  report.statistics = result.statistics;
  report.ranks = ranks;
  add_placed_shapes(library, !quick, report);
  return io::write_collage(folder, report, quick);
}

/// Nothing where mpirun is ending the job, or a question was given up: workers may be gone, or busy with it.
RankStatistics times_of(comm::LoopClock& clock, const master::CollageResult& result) {
  if (comm::stop_signalled() || result.gave_up_question) return {};
  try {
    return clock.stop(result.own_work);
  } catch (const Interrupted&) {
    return {};
  }
}

Start start_of(const CollageArguments& arguments) {
  if (arguments.restart) return Start::restart;
  if (arguments.resume.empty()) return Start::fresh;
  if (arguments.resume == "auto") return automatic_start(output_folder(arguments));
  return arguments.resume == "previous" ? Start::resume_previous : Start::resume;
}

/// Throws InputError where the folder holds another job's finished result, which --resume=auto keeps.
bool nothing_left_to_do(const CollageArguments& arguments, Start start, const std::string& folder, const io::Job& job) {
  return arguments.resume == "auto" && start == Start::fresh && io::is_finished_result_of(folder, job);
}

void say(const CollageArguments& arguments, const std::string& line) {
  if (!arguments.quiet) std::printf("%s\n", line.c_str());
}

/// A finished run needs its checkpoints no more. Returns the exit code.
int conclude(bool unfinished, const CollageCheckpoints& checkpoints) {
  if (unfinished) {
    checkpoints.require_one();
    return kUnfinishedExitCode;
  }
  checkpoints.remove();
  return 0;
}

/// The folder is there then. Returns the place of its lock.
std::string locked_folder(const std::string& folder) {
  io::prepare_output_directory(folder);
  return io::folder_lock_path(folder);
}

/// What rank 0 reads before anything costs time; every mistake is told here.
struct Input {
  Input(const CollageArguments& arguments, Start start)
      : job(io::load_job(arguments.job, arguments.overrides)),
        folder(output_folder(arguments)),
        lock(locked_folder(folder), folder),
        checkpoints(checked_start(folder, start)),
        library(io::open_library_of(job)),
        canvas(io::load_canvas(job.canvas)) {
    io::check_picture_height(job.output, canvas);
    origin = io::make_origin(job, library, canvas);
    from = starting_state(checkpoints, start, origin);
  }
  Input(const Input&) = delete;  // origin points into it
  Input& operator=(const Input&) = delete;

  io::Job job;
  std::string folder;
  io::OutputLock lock;  // before anything in the folder is looked at
  io::CheckpointFolder checkpoints;
  io::LibraryFile library;
  Canvas canvas;
  io::CheckpointOrigin origin;
  std::optional<CheckpointState> from;  // nothing: an empty canvas
};

master::CollageResult run_loop(const CollageArguments& arguments, const Input& input, const TimeLimit& limit,
                               Matcher& matcher, CollageCheckpoints& checkpoints) {
  const CheckpointState* from = input.from ? &*input.from : nullptr;
  if (from) say(arguments, "going on from " + from->name + ", " + std::to_string(from->placements.size()) + " pieces");
  master::LibraryShapes shapes(input.library);
  CollageProgress progress(input.job.settings.stop, arguments.quiet, limit);
  return master::make_collage(input.canvas, input.job.settings, matcher, shapes, progress, {from, &checkpoints});
}

/// Signals and the time limit hold from here on, whatever this rank waits for; so does the watch over the workers.
StopReason watch_waits(comm::Communicator& ranks, const io::Job& job, const TimeLimit& limit) {
  comm::install_stop_handlers();
  // A rank that does not say goodbye is waited for (rank_program.cpp), then killed by mpirun: each takes two seconds.
  const double leaving_s = ranks.size() > 1 ? 4 : 0;
  const StopReason stop_reason = [limit, leaving_s]() -> const char* {
    if (comm::stop_signalled()) return "signal";
    return limit.over(leaving_s) ? "time_limit" : nullptr;
  };
  ranks.interrupt_waits_when(stop_reason);
  ranks.watch_workers(job.comm.silence_s, [](const std::string& line) {
    print_warning(line + " (comm.silence_s): the run ends here");
  });
  return stop_reason;
}

int lead(const CollageArguments& arguments, comm::Communicator& ranks) {
  const TimeLimit limit(
      time_limit_s(arguments.time_limit, std::getenv("SLURM_JOB_END_TIME"), double(std::time(nullptr))));
  const Start start = start_of(arguments);
  const Input input(arguments, start);
  if (nothing_left_to_do(arguments, start, input.folder, input.job)) {
    say(arguments, input.folder + ": finished before, nothing is left to do");
    return 0;
  }
  // Before it is too late, but no question: whoever edits a job and runs it again wants just that.
  print_warning(replaced_result_warning(input.folder, input.job));
  const StopReason stop_reason = watch_waits(ranks, input.job, limit);
  announce_run(ranks, program_identity(), input.job, input.origin.library_digest);
  const std::unique_ptr<Matcher> matcher =
      ranks.size() > 1 ? comm::gather_workers(ranks) : own_matcher(input.job, input.library, stop_reason);

  if (start == Start::restart) input.checkpoints.remove();
  CollageCheckpoints checkpoints(input.checkpoints, input.origin);
  comm::LoopClock clock(ranks);
  const master::CollageResult result = run_loop(arguments, input, limit, *matcher, checkpoints);
  const RankStatistics times = times_of(clock, result);
  const std::string card =
      write(input.folder, input.job, input.canvas, input.library, result, times) + io::ranks_text(times);
  say(arguments, card + "\nwritten to " + input.folder);
  print_warning(empty_result_warning(input.folder, input.job, result));
  return conclude(result.unfinished, checkpoints);
}

}  // namespace

std::string output_folder(const CollageArguments& arguments) {
  if (!arguments.out.empty()) return arguments.out;
  return "out/" + std::filesystem::path(arguments.job).stem().string();
}

int run_collage(const CollageArguments& arguments, comm::Communicator& ranks) {
  if (ranks.rank() != 0) work(ranks);
  try {
    return lead(arguments, ranks);
  } catch (const Interrupted&) {  // before the first round: what was there is there still
    return kUnfinishedExitCode;
  }
}

}  // namespace tessera::cli
