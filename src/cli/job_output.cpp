#include "cli/job_output.h"

#include "io/atomic_file.h"
#include "io/result/collage_files.h"

namespace tessera::cli {

JobOutput::JobOutput(const CollageArguments& collage, const std::vector<std::string>& beside, bool job_only)
    : lock_(collage.job + ".lock", collage.job) {
  io::check_can_be_written(collage.job);
  for (const std::string& path : beside) io::check_can_be_written(path);
  if (job_only) return;
  result_.emplace(output_folder(collage));
  io::check_can_be_published(output_folder(collage));
}

}  // namespace tessera::cli
