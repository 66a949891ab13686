// What rank 0 of tessera collage reads before anything costs time; mistakes in these files and settings are told here.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/collage_checkpoints.h"
#include "cli/collage_run.h"
#include "core/field/canvas.h"
#include "io/checkpoint/checkpoint_folder.h"
#include "io/checkpoint/checkpoint_origin.h"
#include "io/job/job_file.h"
#include "io/library/library_view.h"
#include "io/output_lock.h"
#include "io/result/finished_result.h"

namespace tessera::cli {

struct CollageInput {
  /// Throws InputError and EnvironmentError.
  explicit CollageInput(const CollageArguments& arguments);
  CollageInput(const CollageInput&) = delete;  // origin points into it
  CollageInput& operator=(const CollageInput&) = delete;

  io::Job job;
  std::string folder;
  io::EarlierResult earlier;
  Start start;
  io::CheckpointFolder checkpoints;
  io::LibraryView library;
  std::vector<std::string> palette;  // of silhouettes, "#rrggbb"
  Canvas canvas;
  double room_part =
      1;  // of the canvas, that is filled: where pieces lay that are removed (start.remove), or all of it
  io::CheckpointOrigin origin;
  io::OutputLock lock;                  // of the folder; what is in it counts as it is from then on
  bool finished = false;                // --resume found the finished collage: nothing is left to compute
  std::optional<CheckpointState> from;  // nothing: an empty canvas
};

}  // namespace tessera::cli
