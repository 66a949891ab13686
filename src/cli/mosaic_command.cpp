#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "cli/collage_options.h"
#include "cli/commands.h"
#include "comm/stop_signals.h"
#include "core/base/count_text.h"
#include "core/base/error.h"
#include "job/job_file.h"
#include "library/library_view.h"
#include "products/elements/photo_extraction.h"
#include "products/mosaic/face_search.h"
#include "products/mosaic/mosaic_files.h"
#include "run/job_output.h"
#include "terminal/exit_codes.h"
#include "terminal/shell_word.h"
#include "terminal/terminal.h"

namespace tessera::cli {
namespace {

constexpr const char* kMosaicExamples =
    "Examples:\n"
    "  tessera mosaic portrait.jpg tiles.h5\n"
    "  tessera mosaic portrait.jpg tiles.h5 emoji.h5 --pieces 8000 --shift 8 --out large\n"
    "  mpirun -n 3 tessera mosaic portrait.jpg tiles.h5\n"
    "  tessera mosaic portrait.jpg tiles.h5 --regions 1 --replace     the same image once more, in another way\n"
    "  tessera mosaic portrait.jpg tiles.h5 --job-only     portrait.toml and its two pictures, to be edited; then\n"
    "  tessera collage portrait.toml\n"
    "IMAGE is JPEG, PNG, TIFF, WebP or BMP. The job is a short file with comments. portrait_sizes.png is grey: dark "
    "where\n"
    "the image has details or a face and pieces shall be small. portrait_regions.png shows the parts of the image; "
    "each\n"
    "piece stays within one. Existing files are kept; if they would change, --replace is needed. A library with more "
    "colours\n"
    "is better; 500 drawings are few, 5,000 are many, and with fewer than 100 a drawing may lie beside itself. The "
    "image,\n"
    "a little darker, is shown between the pieces.\n"
    "--set colour.weight=8 shows the image better, but with more gaps; --shift 0 keeps the colours of drawings;\n"
    "--set colour.overlay=0.25 lays the image over the pieces with an opacity of a quarter. All else is as in tessera\n"
    "collage.";

constexpr double kMostShift = 100;  // CIEDE2000; the distance of any two colours is smaller

struct MosaicArguments {
  MosaicRequest request;
  CollageArguments collage;
  bool job_only = false;
};

std::string job_path(const MosaicRequest& request) {
  return request.job.empty() ? std::filesystem::path(request.image).stem().string() + ".toml" : request.job;
}

/// Writes all files or none. A mistake in the overrides is a mistake of the command: it leaves no file behind.
void write_checked(const MosaicArguments& arguments, const Mosaic& mosaic) {
  const comm::StopDelay delay;
  const std::vector<std::string> new_files = write_mosaic(mosaic);
  try {
    load_job(arguments.request.job, arguments.collage.overrides);
  } catch (const InputError&) {
    std::error_code ignored;
    for (const std::string& path : new_files) std::filesystem::remove(path, ignored);
    throw;
  }
}

void print_faces(const MosaicRequest& request, const Mosaic& mosaic) {
  if (const int faces = mosaic.faces.value_or(0); faces > 0) {
    print_line("%s, with the smallest pieces on eyes and mouth%s", count_text(std::size_t(faces), "face").c_str(),
               faces > 1 ? "s" : "");
  }
  if (!request.salient.empty()) {
    print_line("small pieces where %s is white; faces are not looked for", shell_cell(request.salient).c_str());
  }
  if (mosaic.faces || !request.salient.empty()) return;
  print_line(
      "faces were not looked for: %s is missing; Debian's package opencv-data brings it, TESSERA_CASCADES=FOLDER names "
      "another folder, and --salient FILE says where pieces are to be small",
      request.face_cascade.c_str());
}

/// The command that runs the job, with the overrides of --set: they are not in the job file.
std::string next_command(const MosaicArguments& arguments) {
  std::string command = "tessera collage " + shell_word(arguments.request.job);
  for (const std::string& value : arguments.collage.overrides) command += " --set " + shell_word(value);
  return command;
}

void write_job(const MosaicArguments& arguments) {
  MosaicRequest request = arguments.request;
  if (std::isnan(request.shift)) throw InputError("--shift: found nan, allowed: a number");
  for (const std::string& path : request.libraries) {
    std::error_code error;
    if (!std::filesystem::is_directory(path, error)) continue;
    throw InputError(path + ": found a folder, allowed: a library; tessera library build " + shell_word(path) +
                     " -o LIB.h5 makes one of its drawings");
  }
  const LibraryView library({.files = request.libraries, .names = {}});  // first: a mistyped option costs no time
  request.shapes = library.size();
  request.face_cascade = face_cascade_file();
  Drawers drawers(photo_drawer_settings(1));
  const Mosaic mosaic = make_mosaic(request, drawers);
  write_checked(arguments, mosaic);
  const MosaicPlan& plan = mosaic.plan;
  if (arguments.collage.quiet) return;
  const std::string regions = mosaic.regions > 0 ? "; " + count_text(std::size_t(mosaic.regions), "region") + ": " +
                                                       region_picture_path(request.job)
                                                 : "";
  print_line("%s: %d x %d px, about %d pieces of %g to %g px out of %s; sizes: %s%s", request.job.c_str(),
             plan.canvas_px.width, plan.canvas_px.height, plan.pieces, plan.min_scale_px, plan.max_scale_px,
             count_text(library.size(), "shape").c_str(), size_map_path(request.job).c_str(), regions.c_str());
  print_faces(request, mosaic);
  if (arguments.job_only) print_line("next: %s", next_command(arguments).c_str());
  print_now();
}

/// Writes the job, then runs the collage; for rank 0.
int write_and_run(const MosaicArguments& arguments, comm::Communicator& ranks) {
  const std::string& job = arguments.request.job;
  const JobOutput output(arguments.collage, {size_map_path(job), region_picture_path(job)}, arguments.job_only);
  write_job(arguments);
  return arguments.job_only ? kDoneExitCode : collage_exit_code(arguments.collage, ranks);
}

/// Only rank 0 reads the image and writes the job; it sends the job to the workers, as any collage.
int run(MosaicArguments arguments, comm::Communicator& ranks) {
  arguments.request.job = job_path(arguments.request);
  arguments.collage.job = arguments.request.job;
  if (ranks.rank() == 0) return write_and_run(arguments, ranks);
  return arguments.job_only ? kDoneExitCode : collage_exit_code(arguments.collage, ranks);
}

}  // namespace

void add_mosaic_command(CLI::App& app, Command& selected) {
  const auto arguments = std::make_shared<MosaicArguments>();
  MosaicRequest& request = arguments->request;
  CLI::App* mosaic = app.add_subcommand("mosaic", "Show an image by the colours of a library's pieces");
  mosaic->footer(kMosaicExamples);
  mosaic->add_option("IMAGE", request.image, "The image that the mosaic shows")->required()->type_name("FILE");
  mosaic->add_option("LIB", request.libraries, "Libraries of the pieces")->required()->type_name("LIB.h5");
  mosaic
      ->add_option("--pieces", request.pieces,
                   "Approximate number of pieces, 100 to 40000; more pieces show more "
                   "of the image")
      ->capture_default_str();
  mosaic
      ->add_option("--shift", request.shift,
                   "Largest change of each piece's tones towards the image, CIEDE2000; 0 = as drawn")
      ->check(CLI::Range(0.0, kMostShift))
      ->capture_default_str();
  mosaic
      ->add_option("--regions", request.regions,
                   "Divide the image into parts by at most this many colours (up to 8); pieces keep within a part, "
                   "so that its edges are sharp; 1 = pieces lie anywhere, which covers a little more")
      ->capture_default_str();
  mosaic
      ->add_option("--salient", request.salient,
                   "Important places: a grey picture over the image, white where pieces shall be small, black where "
                   "only the image's contrast decides; default: faces that are found")
      ->type_name("FILE");
  mosaic->add_option("--job", request.job, "The job file to write; default: <name of the image>.toml")
      ->type_name("FILE.toml");
  mosaic->add_flag("--job-only", arguments->job_only, "Write the job and its pictures, and run nothing");
  mosaic->add_flag("--replace", request.replace, "Replace the job and the pictures of another mosaic");
  add_collage_options(*mosaic, arguments->collage);
  mosaic->callback([arguments, &selected] {
    selected.run_on_all_ranks = [arguments](comm::Communicator& ranks) { return run(*arguments, ranks); };
  });
}

}  // namespace tessera::cli
