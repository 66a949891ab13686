#include "run/job_output.h"

#include <cstdint>
#include <filesystem>
#include <system_error>

#include "comm/stop_signals.h"
#include "core/base/error.h"
#include "files/atomic_file.h"
#include "files/regular_file.h"
#include "job/job_file.h"
#include "result/collage_files.h"

namespace tessera {
namespace {

std::vector<std::string> files_of(const CollageArguments& collage, const std::vector<std::string>& beside) {
  std::vector<std::string> files = {collage.job};
  files.insert(files.end(), beside.begin(), beside.end());
  return files;
}

}  // namespace

JobOutput::JobOutput(const CollageArguments& collage, const std::vector<std::string>& beside, bool job_only) {
  for (const std::string& path : files_of(collage, beside)) {
    locks_.emplace_back(path + ".lock", path);
    check_can_be_written(path);
  }
  if (job_only) return;
  result_.emplace(output_folder(collage));
  check_can_be_published(output_folder(collage));
}

void write_checked_job(const CollageArguments& collage, const std::string& text) {
  const comm::StopDelay delay;
  const bool is_new = !std::filesystem::exists(collage.job);
  const std::vector<std::uint8_t> before =
      is_new ? std::vector<std::uint8_t>() : read_regular_file(collage.job, kMaxJobBytes);
  write_file_atomically(collage.job, text);
  try {
    load_job(collage.job, collage.overrides);
  } catch (const InputError&) {
    std::error_code ignored;
    if (is_new) std::filesystem::remove(collage.job, ignored);
    if (!is_new) write_file_atomically(collage.job, before);
    throw;
  }
}

}  // namespace tessera
