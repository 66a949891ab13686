#include "cli/job_output.h"

namespace tessera::cli {

JobOutput::JobOutput(const CollageArguments& collage, bool job_only) : lock_(collage.job + ".lock", collage.job) {
  if (!job_only) result_.emplace(output_folder(collage));
}

}  // namespace tessera::cli
