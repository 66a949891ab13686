#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "checkpoint/checkpoint_folder.h"
#include "cli/commands.h"
#include "comm/stop_signals.h"
#include "core/base/error.h"
#include "core/base/split_text.h"
#include "files/output_lock.h"
#include "job/job_keys.h"
#include "job/palette.h"
#include "result/collage_files.h"
#include "result/folder/finished_result.h"
#include "result/folder/result_file.h"
#include "run/collage_run.h"
#include "run/messages/collage_warnings.h"
#include "run/result_drawing_run.h"
#include "run/results/report_run.h"
#include "terminal/terminal.h"

namespace tessera::cli {
namespace {

constexpr const char* kDrawExamples =
    "Examples:\n"
    "  tessera draw out/animals                           collage.svg and collage.png again, as the job says\n"
    "  tessera draw out/animals --width 12000 --png       only the PNG, for print\n"
    "  tessera draw out/animals --pdf                     collage.pdf, with vectors\n"
    "  tessera draw out/animals --width 60000 --tiff      for viewers of large pictures\n"
    "  tessera draw out/animals --background none         transparent between the pieces\n"
    "  tessera draw out/animals --set output.width_mm=420 --set output.dpi=300     42 cm wide on paper\n"
    "  tessera draw out/birds --palette ink --to out/birds-ink     the same collage in other colours, elsewhere\n"
    "  tessera draw out/animals --library moved.h5        if the library has another name now\n"
    "Pieces stay where they are: the pictures are made from the files in RESULT, also of an unfinished collage. Ctrl-C "
    "ends\n"
    "drawing within two seconds with exit code 75 and leaves no half-written picture.";

struct DrawArguments {
  std::string folder;
  int width_px = 0;        // 0: not given
  std::string background;  // empty: not given
  std::string palette;     // empty: not given
  std::vector<std::string> settings;
  PictureRequest request;
  bool quiet = false;
};

/// "#264653,#e76f51" as the list that a job has; a name or a path unchanged.
std::string palette_value(const std::string& text) {
  if (!text.starts_with('#')) return text;
  std::string list;
  for (const std::string_view colour : split_outside(text, ',')) {
    list += (list.empty() ? "" : ", ") + ("\"" + std::string(colour) + "\"");
  }
  return "[" + list + "]";
}

/// The keys for --width, --background and --palette, followed by those of --set, which win.
std::vector<std::string> drawing_keys(const DrawArguments& arguments) {
  std::vector<std::string> keys;
  if (arguments.width_px > 0) {
    keys = {"output.width_mm=0", "output.width_px=" + std::to_string(arguments.width_px)};
  }
  if (!arguments.background.empty()) keys.push_back("output.background=" + arguments.background);
  if (!arguments.palette.empty()) {
    keys.insert(keys.end(), {"colour.pieces=palette", "colour.palette=" + palette_value(arguments.palette)});
  }
  keys.insert(keys.end(), arguments.settings.begin(), arguments.settings.end());
  return keys;
}

/// The job that made a result.
Job job_of_result(const std::string& folder) {
  try {
    return read_result(folder).job;
  } catch (const InputError& error) {
    if (!CheckpointFolder(folder).has_any() || !holder_of_lock(folder_lock_path(folder)).empty()) throw;
    throw InputError(std::string(error.what()) +
                     "; a checkpoint is there: tessera collage with --resume makes the result");
  }
}

Job with_keys(Job job, const std::vector<std::string>& keys) {
  set_drawing_keys(job, keys);
  return job;
}

/// A warning about keys that are given but have no effect. Warnings about the result's own job were printed by its run.
std::string idle_keys_warning(Job job, const std::vector<std::string>& keys) {
  const Job before = job;
  set_drawing_keys(job, keys);
  return joined_warnings(
      {job.output.dpi == before.output.dpi ? "" : idle_dpi_warning(job),
       job.colour.shift == before.colour.shift ? "" : idle_shift_warning(job),
       job.output.background_light == before.output.background_light ? "" : idle_light_warning(job)});
}

/// Throws InputError that names --palette, not the job key that the option sets, where the palette cannot be read.
void check_palette(Job job, const std::vector<std::string>& keys, const std::string& palette) {
  set_drawing_keys(job, keys);
  load_palette(job, "--palette " + palette);
}

/// Refuses the folder of another result, or of a run that can be resumed.
void check_takes_pictures(const std::string& folder) {
  if (is_in_result(folder, kManifestName)) {
    throw InputError("--to " + folder + ": found a result there, allowed: a folder without one");
  }
  if (CheckpointFolder(folder).has_any()) {
    throw InputError("--to " + folder +
                     ": found the checkpoint of an interrupted run there, allowed: a folder without one");
  }
}

/// Locks the result's folder and the pictures' folder against other runs.
class DrawingLocks {
 public:
  DrawingLocks(const std::string& result, const std::string& to) {
    if (!to.empty()) check_takes_pictures(to);  // checked before anything is written there
    lock_result(result, !to.empty());
    if (to.empty()) return;
    prepare_output_directory(to);
    pictures_.emplace(folder_lock_path(to), to);
    check_takes_pictures(to);  // checked again, now with the lock
  }

 private:
  /// Locks the result's folder. Where it is read-only its pictures can still be written elsewhere.
  void lock_result(const std::string& result, bool elsewhere) {
    try {
      result_.emplace(folder_lock_path(result), result);
    } catch (const EnvironmentError&) {
      if (!elsewhere) throw;
    }
  }

  std::optional<OutputLock> result_;
  std::optional<OutputLock> pictures_;  // where the pictures have a folder of their own
};

int run(DrawArguments arguments) {
  PictureRequest& wanted = arguments.request;
  if (!wanted.png && !wanted.svg && !wanted.pdf && !wanted.tiff) wanted.png = wanted.svg = true;
  wanted.keys = drawing_keys(arguments);
  const Job job = job_of_result(arguments.folder);  // first, so that no lock stays where there is no result
  if (!arguments.palette.empty()) check_palette(job, wanted.keys, arguments.palette);
  print_warning(idle_keys_warning(job, wanted.keys));
  const DrawingLocks locks(arguments.folder, wanted.to);
  comm::install_stop_handlers();
  if (!draw(arguments.folder, wanted, arguments.quiet, comm::stop_asked_by_signal)) {
    print_message("drawing interrupted: the same command goes on");
    return kUnfinishedExitCode;
  }
  const bool has_page = wanted.to.empty() && with_keys(job, wanted.keys).output.report;
  if (has_page) write_result_report(arguments.folder);  // with the new picture
  if (!arguments.quiet) print_line("drawn in %s", (wanted.to.empty() ? arguments.folder : wanted.to).c_str());
  return 0;
}

CLI::Range width_range() {
  const JobKey& key = *find_job_key("output", "width_px");
  return {int(key.min), int(key.max)};
}

bool is_colour(std::string_view text) {
  return text.size() == 7 && text[0] == '#' && text.find_first_not_of("0123456789abcdefABCDEF", 1) == text.npos;
}

std::string not_a_colour(const std::string& text) {
  return is_colour(text) || text == kNoColour || text == kImageBackground || text == kPhotoBackground
             ? ""
             : "found " + text + ", allowed: #rrggbb, none, image or photo";
}

/// The mistake in a list of colours; empty where there is none. load_palette checks names and paths.
std::string not_a_palette(const std::string& text) {
  const std::vector<std::string_view> colours = split_outside(text, ',');
  const bool is_list = text.starts_with('#');
  return !is_list || std::all_of(colours.begin(), colours.end(), is_colour)
             ? ""
             : "found " + text + ", allowed: " + joined(built_in_palettes()) +
                   ", a palette file, or #rrggbb,#rrggbb,..";
}

}  // namespace

void add_draw_command(CLI::App& app, Command& selected) {
  const auto arguments = std::make_shared<DrawArguments>();
  CLI::App* draw = app.add_subcommand("draw", "Draw the pictures of a result, at any size");
  draw->footer(kDrawExamples);
  draw->add_option("RESULT", arguments->folder, "The folder of the result")->required()->type_name("DIR");
  draw->add_option("--width", arguments->width_px,
                   "Width of the pictures, which then have no size in mm; default: as in the result's job")
      ->type_name("PX")
      ->check(width_range());
  draw->add_flag("--svg", arguments->request.svg,
                 "Draw collage.svg; without --svg, --png, --pdf and --tiff: SVG and "
                 "PNG");
  draw->add_flag("--png", arguments->request.png, "Draw collage.png");
  draw->add_flag("--pdf", arguments->request.pdf, "Draw collage.pdf");
  draw->add_flag("--tiff", arguments->request.tiff, "Draw collage.tiff: the PNG's picture in tiles and at all sizes");
  draw->add_option("--background", arguments->background,
                   "Colour of the canvas; none: transparent; image: the picture that the pieces show; default: "
                   "output.background")
      ->type_name("#RRGGBB")
      ->check(not_a_colour);
  draw->add_option("--palette", arguments->palette,
                   "Silhouettes in these colours: a built-in palette, a palette file or \"#RRGGBB,#RRGGBB,..\"")
      ->type_name("PALETTE")
      ->check(not_a_palette);
  draw->add_option("--to", arguments->request.to, "Another folder for the pictures; RESULT stays as it is")
      ->type_name("DIR");
  draw->add_option("--set", arguments->settings,
                   "Another value for a key of [output] or [colour] of the job; may be repeated")
      ->type_name("output.KEY=VALUE")
      ->allow_extra_args(false)
      ->take_all();
  draw->add_option("--library", arguments->request.library,
                   "The library, if its file was moved; for several libraries give the option once for each")
      ->type_name("FILE")
      ->allow_extra_args(false);
  draw->add_flag("--quiet", arguments->quiet, "Print no progress, only warnings");
  draw->callback([arguments, &selected] { selected.run = [arguments] { return run(*arguments); }; });
}

}  // namespace tessera::cli
