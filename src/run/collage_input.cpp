#include "run/collage_input.h"

#include <filesystem>
#include <utility>

#include "files/output_folder.h"
#include "job/pieces/start_pieces.h"
#include "result/collage_files.h"
#include "run/refined_result.h"

namespace tessera {
namespace {

Start start_of(const CollageArguments& arguments, const EarlierResult& earlier) {
  if (arguments.restart) return Start::restart;
  if (arguments.resume.empty()) return Start::fresh;
  if (arguments.resume == "auto") return automatic_start(earlier);
  return arguments.resume == "previous" ? Start::resume_previous : Start::resume;
}

Job job_of(const CollageArguments& arguments) {
  Job job = load_job(arguments.job, arguments.overrides);
  return arguments.refined ? with_pieces_of(*arguments.refined, std::move(job)) : job;
}

/// The checkpoints of the run. Where there is no folder yet, mistakes show before it is made.
CheckpointFolder checkpoints_in(const EarlierResult& earlier, Start start) {
  return std::filesystem::exists(earlier.folder) ? CheckpointFolder(earlier.folder) : checked_start(earlier, start);
}

CheckpointOrigin checked_origin(const CollageArguments& arguments, const CanvasProblem& problem) {
  const CheckpointOrigin origin = make_origin(problem.job(), problem.library(), problem.canvas_digest());
  if (arguments.refined) check_is_the_same_collage(*arguments.refined, origin, problem.settings().wishes.given);
  return origin;
}

/// Makes the folder and returns the path of its lock.
std::string locked_folder(const std::string& folder) {
  make_folder(folder);
  return folder_lock_path(folder);
}

}  // namespace

std::string output_folder(const CollageArguments& arguments) {
  if (!arguments.out.empty()) return arguments.out;
  return "out/" + std::filesystem::path(arguments.job).stem().string();
}

CollageInput::CollageInput(const CollageArguments& arguments) : CollageInput(arguments, job_of(arguments)) {}

CollageInput::CollageInput(const CollageArguments& arguments, Job raw)
    : folder(output_folder(arguments)),
      earlier{.folder = folder, .whole = {}, .damage = {}},  // read again when the folder is locked
      start(start_of(arguments, earlier)),
      checkpoints(checkpoints_in(earlier, start)),
      problem(std::move(raw)),
      origin(checked_origin(arguments, problem)),
      lock(locked_folder(folder), folder) {
  check_start_is_elsewhere(problem.job(), folder);
  check_nothing_foreign_is_replaced(folder, arguments.job);
  prepare_output_directory(folder);
  earlier = find_earlier_result(folder);
  start = start_of(arguments, earlier);
  checkpoints = checked_start(earlier, start);
  finished = start == Start::resume && !checkpoints.has_latest();
  if (finished) {
    check_finished_result(earlier, origin, problem.job().start.digest);
  } else {
    from = starting_state(checkpoints, start, origin);
  }
  check_can_be_published(folder);
}

}  // namespace tessera
