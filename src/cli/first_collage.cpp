#include "cli/first_collage.h"

#include <cstdint>
#include <filesystem>

#include "cli/library/library_build_command.h"
#include "core/base/count_text.h"
#include "core/base/error.h"
#include "core/base/rank_pool.h"
#include "files/output_folder.h"
#include "files/regular_file.h"
#include "job/canvas/canvas_file.h"
#include "job/job_file.h"
#include "job/path_in_job.h"
#include "library/library_view.h"
#include "products/first_collage/first_job.h"
#include "run/job_output.h"
#include "terminal/shell_word.h"
#include "terminal/terminal.h"

namespace tessera::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLibraryFolder = "out";
/// Longest side of the box round the silhouette of --canvas.
constexpr int kBox_px = 1200;

/// The last part of the path; also for ".", "drawings/" and a path with "..".
std::string name_of_source(const std::string& source) {
  fs::path path = fs::absolute(source).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  return fs::is_directory(source) ? path.filename().string() : path.stem().string();
}

/// The library of the drawings. A folder's library is built each time: another folder may have the same name.
std::string library_of(const FirstCollageArguments& first, bool quiet) {
  if (first.is_library) return first.source;
  const std::string library = (fs::path(kLibraryFolder) / (name_of_source(first.source) + ".h5")).string();
  make_folder(kLibraryFolder);
  BuildArguments build{.sources = {first.source}, .output = library, .glob = {}, .settings = {}, .quiet = quiet};
  build.settings.files_at_a_time = rank_cores();
  build_library_file(build);
  return library;
}

FirstCanvas canvas_of(const FirstCollageArguments& first, const std::string& job) {
  FirstCanvas canvas;
  if (!first.canvas.empty())
    canvas = {.file = path_in_job(first.canvas, job), .width_px = kBox_px, .height_px = kBox_px};
  if (first.size_px) {
    canvas.width_px = first.size_px->at(0);
    canvas.height_px = first.size_px->at(1);
  }
  canvas.area_px2 = double(canvas.width_px) * canvas.height_px;
  if (first.canvas.empty()) return canvas;
  CanvasSpec spec;
  spec.file = fs::absolute(first.canvas).lexically_normal().string();
  spec.width_px = canvas.width_px;
  spec.height_px = canvas.height_px;
  canvas.area_px2 = load_canvas(spec).area_px2;
  return canvas;
}

/// Whether the user has changed the job that an earlier run wrote: it is kept then, and run with the drawings of today. Throws
/// InputError where the file is another job, or where an option would change a job that is kept.
bool keeps_changed_job(const FirstCollageArguments& first, const std::string& job) {
  if (!fs::exists(job)) return false;
  const std::vector<std::uint8_t> bytes = read_regular_file(job, kMaxJobBytes);
  const std::string text(bytes.begin(), bytes.end());
  if (is_unedited_first_job(text)) return false;
  if (!is_first_job(text)) {
    throw InputError(job + ": exists, and is not the job of a first collage; tessera collage " + shell_word(job) +
                     " runs it; --job FILE.toml writes another one");
  }
  if (first.size_px) {
    throw InputError(job +
                     ": you have changed it, so --size cannot; allowed: canvas.size_px in the job, or --job FILE.toml, "
                     "which writes another one");
  }
  return true;
}

}  // namespace

std::string first_job_path(const FirstCollageArguments& first) {
  if (!first.job.empty()) return first.job;
  const std::string canvas = first.canvas.empty() ? "" : "_" + fs::path(first.canvas).stem().string();
  return name_of_source(first.source) + canvas + ".toml";
}

void write_first_job(const FirstCollageArguments& first, const CollageArguments& collage) {
  const bool keeps_job = keeps_changed_job(first, collage.job);
  const FirstCanvas canvas = canvas_of(first, collage.job);  // first: a mistyped option costs no time
  const std::string library = library_of(first, collage.quiet);
  if (keeps_job) {
    if (!collage.quiet)
      print_line("%s: you have changed it, so it is kept; --job FILE.toml writes another one", collage.job.c_str());
    return print_now();
  }
  const std::size_t shapes = LibraryView({.files = {library}, .names = {}}).size();
  write_checked_job(collage,
                    first_job(name_of_source(first.source), path_in_job(library, collage.job), shapes, canvas));
  if (collage.quiet) return;
  const FirstSizes sizes = first_sizes(canvas.area_px2, shapes);
  print_line("%s: %d x %d px%s, pieces of %g to %g px out of %s; change what you like in it, then: tessera collage %s",
             collage.job.c_str(), canvas.width_px, canvas.height_px,
             first.canvas.empty() ? "" : (" inside " + first.canvas).c_str(), sizes.smallest_px, sizes.largest_px,
             count_text(shapes, "shape").c_str(), shell_word(collage.job).c_str());
  print_now();
}

}  // namespace tessera::cli
