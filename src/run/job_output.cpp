#include "run/job_output.h"

#include "files/atomic_file.h"
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

}  // namespace tessera
