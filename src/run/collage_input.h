// What rank 0 of tessera collage reads before anything costs time; mistakes in these files and settings are told here.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "checkpoint/checkpoint_folder.h"
#include "checkpoint/checkpoint_origin.h"
#include "core/field/canvas.h"
#include "files/output_lock.h"
#include "job/job_file.h"
#include "library/library_view.h"
#include "result/finished_result.h"
#include "run/collage_checkpoints.h"
#include "run/collage_run.h"

namespace tessera {

struct CollageInput {
  /// Throws InputError and EnvironmentError.
  explicit CollageInput(const CollageArguments& arguments);
  CollageInput(const CollageInput&) = delete;  // origin points into it
  CollageInput& operator=(const CollageInput&) = delete;

  Job job;
  std::string folder;
  EarlierResult earlier;
  Start start;
  CheckpointFolder checkpoints;
  LibraryView library;
  std::vector<std::string> palette;  // of silhouettes, "#rrggbb"
  Canvas canvas;
  double room_part =
      1;  // of the canvas, that is filled: where pieces lay that are removed (start.remove), or all of it
  CheckpointOrigin origin;
  OutputLock lock;                      // of the folder; what is in it counts as it is from then on
  bool finished = false;                // --resume found the finished collage: nothing is left to compute
  std::optional<CheckpointState> from;  // nothing: an empty canvas
};

}  // namespace tessera
