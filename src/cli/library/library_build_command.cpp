#include "cli/library/library_build_command.h"

#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "artwork/drawers/drawers.h"
#include "cli/library/build_summary.h"
#include "cli/library/library_output.h"
#include "comm/stop_signals.h"
#include "core/base/count_text.h"
#include "core/base/error.h"
#include "core/base/rank_pool.h"
#include "files/atomic_file.h"
#include "files/output_lock.h"
#include "library/left_out_list.h"
#include "terminal/progress_bar.h"
#include "terminal/terminal.h"

namespace tessera::cli {
namespace {

constexpr char kLibraryBuildExamples[] =
    "Examples:\n"
    "  tessera library build /usr/share/openclipart/svg/animals -o animals.h5\n"
    "  tessera library build logos/ letters/a.png --glob '*.svg' --embed -o mine.h5\n"
    "  tessera library build line_art/ --fill-holes -o lines.h5\n"
    "Reads SVG and SVGZ; PNG, WebP and TIFF with transparency; masks and pictures on a plain background (PNG, WebP,\n"
    "TIFF, BMP, JPEG).\n"
    "Not GIF, PDF, EPS and others: convert them to SVG or PNG. Files that cannot be used are skipped: the first are\n"
    "named at the end, and all of them with reasons in LIB.left_out.txt.";

LibraryBuildReport build_with_progress(const BuildArguments& arguments, const ArtworkFiles& files) {
  std::optional<ProgressBar> bar;
  if (!arguments.quiet) bar.emplace("library", files.paths.size());
  const BuildProgress progress = [&](std::size_t done, std::size_t shapes) {
    if (bar) bar->update(done, count_text(shapes, "shape"));
  };
  Drawers drawers({.processes = arguments.settings.files_at_a_time});
  const LibraryBuildReport report = build_library(files, arguments.output, arguments.settings,
                                                  artwork_loader(drawers, arguments.settings.tracing), progress);
  if (any_failed(drawers.layers())) print_warning(layers_note(drawers.layers()));
  return report;
}

/// Reports what a build left out that wrote no library. Where an older library stays, its list is not replaced. Returns
/// why the list could not be written; mostly empty.
std::string tell_what_was_left_out(const BuildArguments& arguments, const LibraryBuildReport& report) {
  std::error_code error;
  if (std::filesystem::exists(arguments.output, error)) {
    print_lines(left_out_list(report));
    return "";
  }
  try {
    write_left_out_list(arguments.output, report);
    print_line("all that was left out: %s", left_out_path(arguments.output).c_str());
    return "";
  } catch (const EnvironmentError& failure) {
    return std::string("; ") + failure.what();
  }
}

[[noreturn]] void throw_not_written(const BuildArguments& arguments, const LibraryBuildReport& report) {
  const std::string list_problem = tell_what_was_left_out(arguments, report);
  const UnusedFile& first = report.skipped.front();
  const std::string why = report.shapes == 0 ? "no usable shape in " : "--strict; ";
  throw InputError(arguments.output + " was not written: " + why + build_counts(report) + "; the first is " +
                   first.path + ": " + first.reason + list_problem);
}

void throw_if_nothing_found(const BuildArguments& arguments, const ArtworkFiles& files) {
  if (!files.paths.empty() || !files.left_out.empty()) return;
  throw InputError("no artwork in " + arguments.sources.front() +
                   (arguments.glob.empty() ? ": looked for svg, svgz, png, webp, tif, tiff, bmp, jpg and jpeg files"
                                           : ": no file matches " + arguments.glob));
}

/// Refuses nan, which CLI::Range accepts.
void check_is_number(const char* option, float value) {
  if (std::isnan(value)) throw InputError(std::string(option) + ": found nan, allowed: a number");
}

}  // namespace

void build_library_file(const BuildArguments& arguments) {
  check_is_number("--edge-opacity", arguments.settings.tracing.rules.edge_opacity);
  check_is_number("--delta-tau", arguments.settings.tracing.pad.delta_tau);
  const auto start = std::chrono::steady_clock::now();
  const ArtworkFiles files = find_artwork(arguments.sources, arguments.glob);
  throw_if_nothing_found(arguments, files);
  check_replaceable(arguments.output);
  const OutputLock lock(arguments.output + ".lock", arguments.output);
  check_can_be_written(arguments.output);
  check_left_out_list(arguments.output);
  check_is_not_built_from(files.paths, arguments.output);
  const LibraryBuildReport report = build_with_progress(arguments, files);
  const comm::StopDelay delay;  // the library and its list belong together
  if (!arguments.quiet) print_lines(build_summary(report));
  if (!report.written) throw_not_written(arguments, report);
  write_left_out_list(arguments.output, report);
  if (arguments.quiet) return;
  if (!left_out_list(report).empty()) {
    print_line("all that was left out: %s", left_out_path(arguments.output).c_str());
  }
  const std::chrono::duration<double> elapsed_s = std::chrono::steady_clock::now() - start;
  print_line("%s, %.1f MB, %.1f s; of %s", arguments.output.c_str(),
             double(std::filesystem::file_size(arguments.output)) * 1e-6, elapsed_s.count(),
             build_counts(report).c_str());
}

// The options, one in a row of the table.
void add_library_build_command(CLI::App& library, Command& selected) {
  const auto arguments = std::make_shared<BuildArguments>();
  LibraryBuildSettings& settings = arguments->settings;
  settings.files_at_a_time = rank_cores();

  CLI::App* build = library.add_subcommand("build", "Trace artwork files and write a library of shapes");
  build->footer(kLibraryBuildExamples);
  build->add_option("SOURCE", arguments->sources, "Artwork files, and folders that are searched to any depth")
      ->required();
  build->add_option("-o,--output", arguments->output, "The library file to write, replaced if it exists")
      ->required()
      ->type_name("LIB.h5");
  build->add_option("--glob", arguments->glob,
                    "Only files of the folders whose name matches this pattern, e.g. '*.svg'");
  build->add_flag("--embed", settings.embed, "Keep the artwork files themselves in the library");
  build->add_flag("--strict", settings.strict, "Write nothing where a file cannot be used; exit code 2");
  build->add_flag("--keep-rectangles", settings.tracing.rules.keep_rectangles,
                  "Plain rectangles are shapes, too, not a drawing's background");
  build->add_flag("--fill-holes", settings.tracing.rules.fill_holes,
                  "Fill the holes of drawings: for line art, rings, chairs, whose holes other pieces cannot enter");
  build->add_flag(
      "--puzzle", [&settings](std::int64_t) { settings.tracing.rules.keep_rectangles = settings.keep_twins = true; },
      "Each file is a piece: plain rectangles and files that look alike are shapes, too");
  build
      ->add_option("--processes", settings.files_at_a_time,
                   "Number of files traced at a time; default: the number "
                   "of cores")
      ->check(CLI::Range(1, 1024));
  build
      ->add_option("--edge-opacity", settings.tracing.rules.edge_opacity,
                   "Opacity at which the outline runs: 0.05 includes halos and soft shadows; 0.5 leaves these out, but "
                   "includes translucent parts with an edge")
      ->check(CLI::Range(0.02, 0.9))
      ->capture_default_str();
  build
      ->add_option("--pad-levels", settings.tracing.pad.levels,
                   "Levels n of the stored PADs; for jobs with another match.levels they are computed anew")
      ->check(CLI::Range(2, kMaxPadLevels))
      ->capture_default_str();
  build
      ->add_option("--delta-tau", settings.tracing.pad.delta_tau,
                   "Base interval of integral curvature of the stored PADs, rad; for jobs with another "
                   "match.delta_tau they are computed anew")
      ->check(CLI::Range(0.05, 1.0))
      ->capture_default_str();
  build->callback([arguments, &selected] {
    selected.run = [arguments] {
      build_library_file(*arguments);
      return 0;
    };
  });
}

}  // namespace tessera::cli
