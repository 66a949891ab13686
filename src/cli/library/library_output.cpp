#include "cli/library/library_output.h"

#include <filesystem>

#include "cli/library/build_summary.h"
#include "comm/stop_signals.h"
#include "core/base/count_text.h"
#include "core/base/error.h"
#include "files/atomic_file.h"
#include "files/output_lock.h"
#include "library/left_out_list.h"
#include "library/library_copy.h"
#include "terminal/progress_bar.h"
#include "terminal/terminal.h"

namespace tessera::cli {
namespace {

void check_is_no_source(const LibraryChoice& choice, const std::string& output) {
  for (const std::string& file : choice.files) {
    std::error_code error;
    if (std::filesystem::equivalent(file, output, error))
      throw InputError("--output: found " + output + ", which is read; allowed: another file");
  }
  check_is_not_built_from(choice.files, output);
}

LibraryBuildReport report_of(const LibraryView& library) {
  LibraryBuildReport report;
  report.written = true;
  report.shapes = library.size();
  for (const LibraryView::Twin& twin : library.twins())
    report.merged.push_back({twin.path + "/" + twin.name, twin.kept});
  report.files = report.shapes + report.merged.size();
  return report;
}

}  // namespace

void check_replaceable(const std::string& output) {
  std::error_code error;
  if (!std::filesystem::exists(output, error)) return;
  try {
    const LibraryFile library(output);
  } catch (const InputError&) {
    throw InputError(output + ": is there and is no library; give another name, or remove it");
  }
}

void check_is_not_built_from(const std::vector<std::string>& files, const std::string& output) {
  const std::filesystem::path temporary = temporary_path(output);
  for (const std::string& file : files) {
    std::error_code error;
    if (std::filesystem::path(file).filename() == temporary.filename() &&
        std::filesystem::equivalent(file, temporary, error))
      throw InputError("--output: found " + output + ", which is written as " + temporary.string() +
                       " first, and that is read; allowed: another file");
  }
}

void copy_to_library(const LibraryChoice& choice, const std::string& output) {
  check_is_no_source(choice, output);
  check_replaceable(output);
  const OutputLock lock(output + ".lock", output);
  check_can_be_written(output);
  check_left_out_list(output);
  const LibraryView library(choice);
  {
    ProgressBar bar("library", library.size());
    copy_library(library, output, [&](std::size_t done) { bar.update(done); });
  }
  const comm::StopDelay delay;  // the library and its list belong together
  const LibraryBuildReport report = report_of(library);
  write_left_out_list(output, report);
  print_lines(build_summary(report));
  if (!report.merged.empty()) print_line("all that was left out: %s", left_out_path(output).c_str());
  print_line("%s, %.1f MB, %s", output.c_str(), double(std::filesystem::file_size(output)) * 1e-6,
             count_text(report.shapes, "shape").c_str());
}

}  // namespace tessera::cli
