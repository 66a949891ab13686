#include "cli/library_output.h"

#include <filesystem>

#include "cli/build_summary.h"
#include "cli/progress_bar.h"
#include "cli/terminal.h"
#include "comm/stop_signals.h"
#include "core/base/count_text.h"
#include "core/base/error.h"
#include "io/atomic_file.h"
#include "io/library/left_out_list.h"
#include "io/library/library_copy.h"
#include "io/output_lock.h"

namespace tessera::cli {
namespace {

void check_is_no_source(const io::LibraryChoice& choice, const std::string& output) {
  for (const std::string& file : choice.files) {
    std::error_code error;
    if (std::filesystem::equivalent(file, output, error))
      throw InputError("--output: found " + output + ", which is read; allowed: another file");
  }
  check_is_not_built_from(choice.files, output);
}

io::LibraryBuildReport report_of(const io::LibraryView& library) {
  io::LibraryBuildReport report;
  report.written = true;
  report.shapes = library.size();
  for (const io::LibraryView::Twin& twin : library.twins())
    report.merged.push_back({twin.path + "/" + twin.name, twin.kept});
  report.files = report.shapes + report.merged.size();
  return report;
}

}  // namespace

void check_replaceable(const std::string& output) {
  std::error_code error;
  if (!std::filesystem::exists(output, error)) return;
  try {
    const io::LibraryFile library(output);
  } catch (const InputError&) {
    throw InputError(output + ": is there and is no library; give another name, or remove it");
  }
}

void check_is_not_built_from(const std::vector<std::string>& files, const std::string& output) {
  const std::filesystem::path temporary = io::temporary_path(output);
  for (const std::string& file : files) {
    std::error_code error;
    if (std::filesystem::path(file).filename() == temporary.filename() &&
        std::filesystem::equivalent(file, temporary, error))
      throw InputError("--output: found " + output + ", which is written as " + temporary.string() +
                       " first, and that is read; allowed: another file");
  }
}

void copy_to_library(const io::LibraryChoice& choice, const std::string& output) {
  check_is_no_source(choice, output);
  check_replaceable(output);
  const io::OutputLock lock(output + ".lock", output);
  io::check_can_be_written(output);
  io::check_left_out_list(output);
  const io::LibraryView library(choice);
  {
    ProgressBar bar("library", library.size());
    io::copy_library(library, output, [&](std::size_t done) { bar.update(done); });
  }
  const comm::StopDelay delay;  // for the list that belongs to it
  const io::LibraryBuildReport report = report_of(library);
  io::write_left_out_list(output, report);
  print_lines(build_summary(report));
  if (!report.merged.empty()) print_line("all that was left out: %s", io::left_out_path(output).c_str());
  print_line("%s, %.1f MB, %s", output.c_str(), double(std::filesystem::file_size(output)) * 1e-6,
             count_text(report.shapes, "shape").c_str());
}

}  // namespace tessera::cli
