// Counters and times of a run. They never affect the picture.
#pragma once

#include <cstdint>
#include <optional>

#include "core/base/stop.h"

namespace tessera {

/// Counters and times of one run, including the columns of the paper's Table 2.
struct RunStatistics {
  std::uint64_t shapes = 0;  // "No. of candidates"
  double pads_per_shape = 0;
  std::uint64_t rounds = 0;              // "No. of iterations"
  std::uint64_t docking_choices = 0;     // all pairs (target sample, shape PAD), and random tangent dockings
  std::uint64_t dockings_evaluated = 0;  // dockings that were tested on the field
  std::uint64_t refined = 0;
  std::uint64_t target_samples = 0;  // matched samples, repeats included
  std::uint64_t trials = 0;          // of improving
  std::uint64_t trials_kept = 0;
  double prune_s = 0;
  double dock_s = 0;     // docking, refining, and measuring candidates again after changes around them
  double ahead_s = 0;    // checking candidates during dock_s; processor time
  double replace_s = 0;  // asking for replacement trials, and waiting for their outcomes
  double objective_s = 0;
  double merge_s = 0;
  double improve_s = 0;                  // part of total_s; the other times do not include the trials
  double total_s = 0;                    // of the loop, without the set-up of canvas and collage
  std::optional<double> last_tenth;      // fraction of the canvas covered in the last tenth of total_s; empty: unknown
  double setup_processor_s = 0;          // of this process, before the loop
  std::optional<StopReason> stopped_by;  // empty: the run goes on

  double pruned_fraction() const {
    return docking_choices ? 1.0 - double(dockings_evaluated) / double(docking_choices) : 0.0;
  }
};

}  // namespace tessera
