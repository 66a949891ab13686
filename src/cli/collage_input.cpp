#include "cli/collage_input.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include "cli/refined_result.h"
#include "core/field/room.h"
#include "core/matching/sized_settings.h"
#include "io/job/canvas_file.h"
#include "io/job/job_library.h"
#include "io/job/overlays.h"
#include "io/job/palette.h"
#include "io/job/picture_size.h"
#include "io/job/start_pieces.h"
#include "io/result/collage_files.h"
#include "io/result/ground_tile.h"

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

/// Where pieces are removed only their room is filled, and as far round it as a gap may be that nothing fits into. Which
/// part of the canvas that is.
double limit_to_room(const io::ShapeLibrary& library, const io::Job& job, Canvas& canvas) {
  if (job.start.removed.empty()) return 1;
  constexpr io::LibraryParts kOutlines{.outline = true, .field = false, .levels = 0, .artwork = false};
  std::map<ShapeId, Outline> outlines;
  std::vector<PieceThatLay> lay;
  for (const GivenPiece& piece : job.start.removed) {
    const auto [at, is_new] = outlines.try_emplace(piece.shape);
    const std::uint32_t i = index_of(piece.shape);
    if (is_new) at->second = std::move(library.read(i, i + 1, kOutlines).front().outline);
    lay.push_back({&at->second, piece.canvas_from_shape});
  }
  fill_only_where_they_lay(lay, job.settings.pieces.min_scale_px, canvas);
  double area_px2 = 0;
  for (const CanvasRegion& region : canvas.regions) area_px2 += region.area_px2;
  return std::min(1., area_px2 / canvas.area_px2);
}

/// Whose names the job's wishes are about.
io::LibraryView library_for(io::Job& job) {
  io::LibraryView library = io::open_library_of(job);
  io::resolve_wishes(library, job);
  io::add_start_pieces(library, job);
  return library;
}

/// With the factor of the sizes, which goes by the canvas' area.
Canvas checked_canvas(const io::ShapeLibrary& library, io::Job& job) {
  Canvas canvas = io::canvas_of(job);
  io::check_picture_size(io::on_paper(job.output, job.canvas, canvas), canvas);
  io::check_ground(job, canvas);
  if (job.settings.pieces.fit_all) {
    job.size_factor =
        first_size_factor(job.settings, std::uint32_t(library.size()), canvas.area_px2, library.drawings());
  }
  io::set_overlays(io::read_overlays(canvas, job), library, job);
  io::check_images(canvas, with_sizes_times(job.size_factor, job.settings).pieces);
  return canvas;
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
      library(library_for(job)),
      palette(io::load_palette(job)),
      canvas(checked_canvas(library, job)),
      origin(checked_origin(arguments, job, library, canvas)),
      lock(locked_folder(folder), folder) {
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
}

}  // namespace tessera::cli
