// Guards the output of a command that writes a job and then runs it like tessera collage.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "files/output_folder.h"
#include "files/output_lock.h"
#include "run/collage_run.h"

namespace tessera {

/// Locks the job's file and the files beside it against other runs, and finds out at once whether these and the result can
/// be written.
class JobOutput {
 public:
  /// `collage.job`: the file to write. `beside`: other files that are written with it. `job_only`: no result follows.
  /// Throws InputError where another run is at work, EnvironmentError.
  JobOutput(const CollageArguments& collage, const std::vector<std::string>& beside, bool job_only);

 private:
  std::deque<OutputLock> locks_;
  std::optional<OutputFolder> result_;
};

/// Writes a job that a command made. Where an override of --set is wrong, the file is again what it was, and InputError is
/// thrown.
void write_checked_job(const CollageArguments& collage, const std::string& text);

}  // namespace tessera
