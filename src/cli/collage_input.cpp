#include "cli/collage_input.h"

#include <filesystem>

#include "io/job/canvas_file.h"
#include "io/job/job_library.h"
#include "io/result/collage_files.h"
#include "io/result/finished_result.h"

namespace tessera::cli {
namespace {

Start start_of(const CollageArguments& arguments) {
  if (arguments.restart) return Start::restart;
  if (arguments.resume.empty()) return Start::fresh;
  if (arguments.resume == "auto") return automatic_start(output_folder(arguments));
  return arguments.resume == "previous" ? Start::resume_previous : Start::resume;
}

Canvas checked_canvas(const io::Job& job) {
  Canvas canvas = io::load_canvas(job.canvas);
  io::check_picture_height(job.output, canvas);
  return canvas;
}

/// What is in a folder counts when it is locked; where there is none, there is nothing to wait for.
io::CheckpointFolder checkpoints_in(const std::string& folder, Start start) {
  return std::filesystem::exists(folder) ? io::CheckpointFolder(folder) : checked_start(folder, start);
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
    : start(start_of(arguments)),
      job(io::load_job(arguments.job, arguments.overrides)),
      folder(output_folder(arguments)),
      checkpoints(checkpoints_in(folder, start)),
      library(io::open_library_of(job)),
      canvas(checked_canvas(job)),
      lock(locked_folder(folder), folder) {
  io::check_nothing_foreign_is_replaced(folder, arguments.job);
  io::prepare_output_directory(folder);
  start = start_of(arguments);  // another run may have changed the folder until it was locked
  checkpoints = checked_start(folder, start);
  origin = io::make_origin(job, library, canvas);
  finished = start == Start::resume && !checkpoints.has_latest();
  if (finished) {
    io::check_finished_result(folder, origin);
  } else {
    from = starting_state(checkpoints, start, origin);
  }
}

}  // namespace tessera::cli
