#include "cli/collage_input.h"

#include <filesystem>
#include <utility>

#include "cli/checked_job.h"
#include "cli/refined_result.h"
#include "io/job/palette.h"
#include "io/job/start_pieces.h"
#include "io/result/collage_files.h"

namespace tessera::cli {
namespace {

Start start_of(const CollageArguments& arguments, const io::EarlierResult& earlier) {
  if (arguments.restart) return Start::restart;
  if (arguments.resume.empty()) return Start::fresh;
  if (arguments.resume == "auto") return automatic_start(earlier);
  return arguments.resume == "previous" ? Start::resume_previous : Start::resume;
}

io::Job job_of(const CollageArguments& arguments) {
  io::Job job = io::load_job(arguments.job, arguments.overrides);
  return arguments.refined ? with_pieces_of(*arguments.refined, std::move(job)) : job;
}

/// Where there is no folder, mistakes show before it is made.
io::CheckpointFolder checkpoints_in(const io::EarlierResult& earlier, Start start) {
  return std::filesystem::exists(earlier.folder) ? io::CheckpointFolder(earlier.folder) : checked_start(earlier, start);
}

io::CheckpointOrigin checked_origin(const CollageArguments& arguments, const io::Job& job,
                                    const io::ShapeLibrary& library, const Canvas& canvas) {
  const io::CheckpointOrigin origin = io::make_origin(job, library, canvas);
  if (arguments.refined) check_is_the_same_collage(*arguments.refined, origin);
  return origin;
}

/// The folder is there then. Returns the place of its lock.
std::string locked_folder(const std::string& folder) {
  io::create_output_directory(folder);
  return io::folder_lock_path(folder);
}

}  // namespace

std::string output_folder(const CollageArguments& arguments) {
  if (!arguments.out.empty()) return arguments.out;
  return "out/" + std::filesystem::path(arguments.job).stem().string();
}

CollageInput::CollageInput(const CollageArguments& arguments)
    : job(job_of(arguments)),
      folder(output_folder(arguments)),
      earlier{.folder = folder, .whole = {}, .damage = {}},  // what is in a folder counts when it is locked
      start(start_of(arguments, earlier)),
      checkpoints(checkpoints_in(earlier, start)),
      library(checked_library(job)),
      palette(io::load_palette(job)),
      canvas(checked_canvas(library, job)),
      origin(checked_origin(arguments, job, library, canvas)),
      lock(locked_folder(folder), folder) {
  keep_removed_from_coming_back(library, canvas, job);
  room_part = limit_to_room(library, job, canvas);
  io::check_start_is_elsewhere(job, folder);
  io::check_nothing_foreign_is_replaced(folder, arguments.job);
  io::prepare_output_directory(folder);
  earlier = io::find_earlier_result(folder);
  start = start_of(arguments, earlier);
  checkpoints = checked_start(earlier, start);
  finished = start == Start::resume && !checkpoints.has_latest();
  if (finished) {
    io::check_finished_result(earlier, origin);
  } else {
    from = starting_state(checkpoints, start, origin);
  }
  io::check_can_be_published(folder);
}

}  // namespace tessera::cli
