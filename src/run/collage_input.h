// The files that rank 0 of tessera collage reads before anything costs time. Mistakes in files and settings are reported
// here.
#pragma once

#include <optional>
#include <string>

#include "checkpoint/checkpoint_folder.h"
#include "checkpoint/checkpoint_origin.h"
#include "files/output_lock.h"
#include "result/folder/finished_result.h"
#include "run/collage_checkpoints.h"
#include "run/collage_problem.h"
#include "run/collage_run.h"

namespace tessera {

struct CollageInput {
  /// Throws InputError and EnvironmentError.
  explicit CollageInput(const CollageArguments& arguments);

  std::string folder;
  EarlierResult earlier;
  Start start;
  CheckpointFolder checkpoints;
  const CanvasProblem problem;
  CheckpointOrigin origin;
  OutputLock lock;                      // of the folder; what is in it counts from then on
  bool finished = false;                // --resume found a finished collage: nothing is left to compute
  std::optional<CheckpointState> from;  // empty: starts with an empty canvas

 private:
  CollageInput(const CollageArguments& arguments, Job raw);
};

}  // namespace tessera
