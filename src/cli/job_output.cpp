#include "cli/job_output.h"

#include "io/atomic_file.h"
#include "io/result/collage_files.h"

namespace tessera::cli {
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
    io::check_can_be_written(path);
  }
  if (job_only) return;
  result_.emplace(output_folder(collage));
  io::check_can_be_published(output_folder(collage));
}

}  // namespace tessera::cli
