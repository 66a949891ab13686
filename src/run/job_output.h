// A command that writes a job and then runs it as tessera collage does: what it holds while it is at work.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "files/output_folder.h"
#include "files/output_lock.h"
#include "run/collage_run.h"

namespace tessera {

/// Keeps other runs away from the job's file and those beside it, and finds at once where it or the result could not be
/// written.
class JobOutput {
 public:
  /// `collage.job`: the file to write; `beside`: the others that are written with it. `job_only`: no result follows.
  /// Throws InputError where another run is at work, EnvironmentError.
  JobOutput(const CollageArguments& collage, const std::vector<std::string>& beside, bool job_only);

 private:
  std::deque<OutputLock> locks_;
  std::optional<OutputFolder> result_;
};

}  // namespace tessera
