#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "cli/collage_options.h"
#include "cli/commands.h"
#include "core/base/count_text.h"
#include "core/base/error.h"
#include "core/base/rank_pool.h"
#include "files/regular_file.h"
#include "job/job_file.h"
#include "job/job_keys.h"
#include "products/texture/texture_files.h"
#include "program/list_option.h"
#include "run/job_output.h"
#include "terminal/exit_codes.h"
#include "terminal/shell_word.h"
#include "terminal/terminal.h"

namespace tessera::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTextureExamples =
    "Examples:\n"
    "  tessera texture wall.jpg                            a wall without seams: out/wall_texture/collage.png\n"
    "  tessera texture wall.jpg --size 2048,1024 --out big\n"
    "  tessera texture gravel.jpg --element-px 22          elements of about this size\n"
    "  mpirun -n 3 tessera texture wall.jpg                rank 0 is the master, the others are workers\n"
    "  tessera texture wall.jpg --job-only                 the job and its files, to be edited; then\n"
    "  tessera collage wall_texture.toml\n"
    "PHOTO shows many stones, bricks, tiles, coins or leaves; it is JPEG, PNG, TIFF, WebP or BMP. The elements are "
    "found,\n"
    "and laid side by side as they lie in the photo, on a canvas whose opposite edges fit together; others fill the "
    "gaps.\n"
    "Between them is the photo's own ground. wall_texture.h5 is the library of the elements, "
    "wall_texture_layout.geojson\n"
    "where they begin, wall_texture_ground.png what lies between them. If you change wall_texture.toml, it is kept.\n"
    "All else is as in tessera collage.";

struct TextureArguments {
  TextureRequest request;
  CollageArguments collage;
  bool job_only = false;
};

std::string job_path(const TextureRequest& request) {
  return request.job.empty() ? fs::path(request.photo).stem().string() + "_texture.toml" : request.job;
}

/// Whether the user has changed the job that an earlier run wrote. Throws InputError where the files are not of a texture.
bool keeps_changed_job(const TextureRequest& request) {
  std::error_code error;
  const bool has_job = fs::exists(request.job, error);
  for (const std::string& path : {request.job, texture_library_path(request.job), texture_layout_path(request.job),
                                  texture_ground_path(request.job)}) {
    if (fs::equivalent(path, request.photo, error))
      throw InputError("--job " + request.job + ": would write " + path + ", the photo; allowed: another name");
    if (fs::exists(path, error) && !has_job)
      throw InputError(path + ": exists and was not made by tessera texture; give another name with --job");
  }
  if (!has_job) return false;
  const std::vector<std::uint8_t> bytes = read_regular_file(request.job, kMaxJobBytes);
  const std::string text(bytes.begin(), bytes.end());
  if (is_unedited_texture_job(text)) return false;
  if (is_texture_job(text)) return true;
  throw InputError(request.job + ": exists and was not made by tessera texture; give another name with --job");
}

/// The canvas of the job, which the user may have changed. Throws InputError where --size is another one.
cv::Size canvas_of(const TextureArguments& arguments, const TexturePlan& plan) {
  const CanvasSpec canvas = load_job(arguments.request.job, arguments.collage.overrides).canvas;
  const cv::Size size_px(canvas.width_px, canvas.height_px), planned_px = plan.texture_px * plan.enlarged;
  if (arguments.request.size_px.empty() || size_px == planned_px) return size_px;
  const auto text = [](cv::Size size) { return std::to_string(size.width) + ", " + std::to_string(size.height); };
  throw InputError(arguments.request.job + ": you have changed it, and its canvas.size_px is [" + text(size_px) +
                   "], with this --size it is [" + text(planned_px) +
                   "]; allowed: the same, or --job FILE.toml, which writes another job");
}

/// Throws InputError where no job may have such a canvas.
void check_size(const TextureRequest& request) {
  if (double(request.size_px.width) * request.size_px.height <= kMaxCanvas_px2) return;
  throw InputError("--size: found " + std::to_string(request.size_px.width) + "," +
                   std::to_string(request.size_px.height) + ", allowed: at most 100 million px");
}

void write_files(const TextureArguments& arguments) {
  const TextureRequest& request = arguments.request;
  check_size(request);
  const bool quiet = arguments.collage.quiet, keeps_job = keeps_changed_job(request);
  Drawers drawers(photo_drawer_settings(rank_cores()));
  const TextureDraft draft = draft_texture(request, drawers);
  if (!quiet) {
    print_line("%s: %s%s", request.photo.c_str(), count_text(draft.extraction.cut_outs.size(), "element").c_str(),
               draft.plan.enlarged > 1 ? (", enlarged " + std::to_string(draft.plan.enlarged) + " times").c_str() : "");
    print_now();
  }
  // The job comes first: it tells a later run whose the files beside it are.
  if (!keeps_job) write_checked_job(arguments.collage, draft.job);
  const cv::Size canvas_px = canvas_of(arguments, draft.plan);
  const std::size_t laid = write_texture_files(request, draft, canvas_px, drawers);
  if (quiet) return;
  print_line("%s: %zu pieces on %d x %d px", texture_layout_path(request.job).c_str(), laid,
             canvas_px.width / draft.plan.enlarged, canvas_px.height / draft.plan.enlarged);
  if (keeps_job)
    print_line("%s: you have changed it, so it is kept; --job FILE.toml writes another one", request.job.c_str());
  if (arguments.job_only) print_line("next: tessera collage %s", shell_word(request.job).c_str());
  print_now();
}

/// Writes the job, then runs the collage; for rank 0.
int write_and_run(const TextureArguments& arguments, comm::Communicator& ranks) {
  const std::string& job = arguments.request.job;
  const JobOutput output(arguments.collage,
                         {texture_library_path(job), texture_layout_path(job), texture_ground_path(job)},
                         arguments.job_only);
  write_files(arguments);
  return arguments.job_only ? kDoneExitCode : collage_exit_code(arguments.collage, ranks);
}

/// Only rank 0 reads the photo and writes the job; it sends the job to the workers, as any collage.
int run(TextureArguments arguments, comm::Communicator& ranks) {
  arguments.request.job = job_path(arguments.request);
  arguments.collage.job = arguments.request.job;
  if (ranks.rank() == 0) return write_and_run(arguments, ranks);
  return arguments.job_only ? kDoneExitCode : collage_exit_code(arguments.collage, ranks);
}

}  // namespace

void add_texture_command(CLI::App& app, Command& selected) {
  const auto arguments = std::make_shared<TextureArguments>();
  TextureRequest& request = arguments->request;
  CLI::App* texture = app.add_subcommand("texture", "Make a larger texture without seams of a photo's elements");
  texture->footer(kTextureExamples);
  texture->add_option("PHOTO", request.photo, "A photo of many stones, bricks, tiles, coins or leaves")
      ->required()
      ->type_name("FILE");
  add_list_option<int>(
      *texture, "--size",
      [arguments](std::vector<int> given) {
        arguments->request.size_px = {given[0], given[1]};
      },
      "Width and height of the texture, px, elements as large as in the photo; default: twice those of "
      "the photo, at most 4096",
      {.type_name = "W,H", .count = 2, .value = CLI::Range(kLeastTextureSide_px, 20'000)});
  texture
      ->add_option("--element-px", request.element_px,
                   "Short side of a typical element, px of the photo; default: found")
      ->check(CLI::Range(4.0, 50'000.0));
  texture
      ->add_option("--labels", request.labels, "Labels of the photo's pixels from another program, instead of a search")
      ->type_name("MAP.png");
  texture->add_option("--job", request.job, "The job file to write; default: <name of the photo>_texture.toml")
      ->type_name("FILE.toml");
  texture->add_flag("--job-only", arguments->job_only, "Write the job and its files, and run nothing");
  add_collage_options(*texture, arguments->collage);
  texture->callback([arguments, &selected] {
    selected.run_on_all_ranks = [arguments](comm::Communicator& ranks) { return run(*arguments, ranks); };
  });
}

}  // namespace tessera::cli
