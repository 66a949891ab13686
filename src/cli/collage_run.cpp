#include "cli/collage_run.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <optional>
#include <set>
#include <thread>

#include "cli/collage_checkpoints.h"
#include "cli/collage_journal.h"
#include "cli/collage_progress.h"
#include "cli/collage_warnings.h"
#include "cli/command_line.h"
#include "cli/time_limit.h"
#include "comm/loop_clock.h"
#include "comm/matcher_server.h"
#include "comm/node_turn.h"
#include "comm/rank_sites.h"
#include "comm/stop_signals.h"
#include "comm/worker_team.h"
#include "core/base/version.h"
#include "core/matching/matching_context.h"
#include "core/ranks/partition.h"
#include "io/job/canvas_file.h"
#include "io/job/job_file.h"
#include "io/job/job_library.h"
#include "io/library/shape_models.h"
#include "io/result/collage_files.h"
#include "io/result/finished_result.h"
#include "io/result/rank_table.h"
#include "io/utc_time.h"
#include "master/collage_loop.h"
#include "master/library_shapes.h"
#include "worker/device_group.h"

namespace tessera::cli {
namespace {

std::string output_folder(const CollageArguments& arguments) {
  if (!arguments.out.empty()) return arguments.out;
  return "out/" + std::filesystem::path(arguments.job).stem().string();
}

comm::Bytes to_bytes(const std::string& text) { return {text.begin(), text.end()}; }
std::string to_text(const comm::Bytes& bytes) { return {bytes.begin(), bytes.end()}; }

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

std::string host_name() {
  char name[256] = "";
  gethostname(name, sizeof name - 1);
  return name;
}

RankSite site_with(const io::Job& job, const worker::DeviceShare& share) {
  return {host_name(), worker::describe(worker::chosen_devices(job.devices, share))};
}

[[noreturn]] void work(comm::Communicator& ranks) {
  const io::Job job = io::job_from_toml(to_text(ranks.broadcast({})), "the master's job");
  const io::LibraryFile library = io::open_library_of(job);
  const ShapeRange part = even_range(library.size(), ranks.rank() - 1, ranks.size() - 1);
  const MatchingContext context = context_of(job, library);
  const worker::DeviceShare share = share_node(ranks, job);
  comm::tell_site(ranks, site_with(job, share));
  comm::first_worker_of_node_first(ranks, [&] { worker::compile_kernels(job.devices, context); });
  comm::serve(ranks, worker::make_device_matcher(job.devices, context, part, io::models_of(library, context), share));
}

/// The whole library on this rank's devices.
std::unique_ptr<Matcher> own_matcher(const io::Job& job, const io::LibraryFile& library) {
  const MatchingContext context = context_of(job, library);
  const ShapeRange all = even_range(library.size(), 0, 1);
  return worker::make_device_matcher(job.devices, context, all, io::models_of(library, context),
                                     {.per_worker = job.devices_per_worker});
}

RankSite own_site(const io::Job& job) { return site_with(job, {.per_worker = job.devices_per_worker}); }

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
                  const master::CollageResult& result, const RankStatistics& ranks, const io::RunRecord& record) {
  // mpirun kills all ranks two seconds after Ctrl-C, and a time limit has little room for a picture.
  const bool quick = result.unfinished || comm::stop_signalled();
  io::CollageReport report;
  report.job = &job;
  report.canvas = &canvas;
  report.placements = result.placements;
  report.statistics = result.statistics;
  report.ranks = ranks;
  report.record = record;
  add_placed_shapes(library, !quick, report);
  return io::write_collage(folder, report, quick);
}

/// Nothing where mpirun is ending the job: it may have ended workers already, who would never answer.
RankStatistics times_of(comm::LoopClock& clock, const master::CollageResult& result) {
  return comm::stop_signalled() ? RankStatistics{} : clock.stop(result.own_work);
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

/// What rank 0 reads before anything costs time; every mistake is told here.
struct Input {
  Input(const CollageArguments& arguments, Start start)
      : job(io::load_job(arguments.job, arguments.overrides)),
        folder(output_folder(arguments)),
        checkpoints(checked_start(folder, start)),
        library(io::open_library_of(job)),
        canvas(io::load_canvas(job.canvas)) {
    io::check_picture_height(job.output, canvas);
    io::prepare_output_directory(folder);
    origin = io::make_origin(job, library, canvas);
    from = starting_state(checkpoints, start, origin);
  }
  Input(const Input&) = delete;  // origin points into it
  Input& operator=(const Input&) = delete;

  io::Job job;
  std::string folder;
  io::CheckpointFolder checkpoints;
  io::LibraryFile library;
  Canvas canvas;
  io::CheckpointOrigin origin;
  std::optional<CheckpointState> from;  // nothing: an empty canvas
};

io::RunRecord record_of(const Input& input) {
  io::RunRecord record;
  record.version = program_version();
  record.commit = program_commit();
  record.command_line = own_command_line();
  record.job_file = std::filesystem::absolute(input.job.path).string();
  record.library_file = input.job.library;
  record.library_digest = input.origin.library_digest;
  record.started_utc = io::utc_now();
  return record;
}

master::CollageResult run_loop(const CollageArguments& arguments, const Input& input, const TimeLimit& limit,
                               Matcher& matcher, CollageCheckpoints& checkpoints) {
  const CheckpointState* from = input.from ? &*input.from : nullptr;
  if (from) say(arguments, "going on from " + from->name + ", " + std::to_string(from->placements.size()) + " pieces");
  comm::install_stop_handlers();
  master::LibraryShapes shapes(input.library);
  CollageProgress progress(input.job.settings.stop, arguments.quiet, limit);
  return master::make_collage(input.canvas, input.job.settings, matcher, shapes, progress, {from, &checkpoints});
}

/// From the master's job to the files of the result; returns the exit code.
int make(const CollageArguments& arguments, const Input& input, Start start, const TimeLimit& limit,
         comm::Communicator& ranks, CollageJournal& journal) {
  // Before it is too late, but no question: whoever edits a job and runs it again wants just that.
  journal.warn(replaced_result_warning(input.folder, input.job));
  if (input.from) journal.resumed(*input.from);
  ranks.broadcast(to_bytes(io::to_toml(input.job)));
  const std::unique_ptr<Matcher> matcher =
      ranks.size() > 1 ? comm::gather_workers(ranks) : own_matcher(input.job, input.library);
  journal.ranks_are(comm::gather_sites(ranks, ranks.size() > 1 ? RankSite{host_name(), {}} : own_site(input.job)));

  if (start == Start::restart) input.checkpoints.remove();
  CollageCheckpoints checkpoints(input.checkpoints, input.origin);
  comm::LoopClock clock(ranks);
  const master::CollageResult result = run_loop(arguments, input, limit, *matcher, checkpoints);
  const RankStatistics times = times_of(clock, result);
  journal.warn(empty_result_warning(input.folder, input.job, result));
  journal.keep_warning(checkpoints.warning());
  const io::RunRecord& record = journal.ended(result.statistics.stopped_by, result.placements.size());
  const std::string card =
      write(input.folder, input.job, input.canvas, input.library, result, times, record) + io::ranks_text(times);
  say(arguments, card + "\nwritten to " + input.folder);
  return conclude(result.unfinished, checkpoints);
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
  CollageJournal journal(input.folder, record_of(input));
  return journal.watch([&] { return make(arguments, input, start, limit, ranks, journal); });
}

}  // namespace

int run_collage(const CollageArguments& arguments, comm::Communicator& ranks) {
  if (ranks.rank() == 0) return lead(arguments, ranks);
  work(ranks);
}

}  // namespace tessera::cli
