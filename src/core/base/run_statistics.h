// What a run counted and how long its stages took. It never decides anything.
#pragma once

#include <cstdint>
#include <optional>

#include "core/base/stop.h"

namespace tessera {

/// Counters and times of one run, with the columns of the paper's Table 2.
struct RunStatistics {
  std::uint64_t shapes = 0;  // "No. of candidates"
  double pads_per_shape = 0;
  std::uint64_t rounds = 0;              // "No. of iterations"
  std::uint64_t docking_choices = 0;     // all pairs (target sample, shape PAD), and tangent dockings drawn
  std::uint64_t dockings_evaluated = 0;  // those that reached the field
  std::uint64_t refined = 0;
  std::uint64_t target_samples = 0;  // matched, repeats included
  std::uint64_t trials = 0;          // of improving
  std::uint64_t trials_kept = 0;
  double prune_s = 0;
  double dock_s = 0;     // docking, refining, and measuring candidates whose surroundings changed
  double ahead_s = 0;    // of dock_s, processor time: checking candidates meanwhile
  double replace_s = 0;  // asking for replacement trials, and waiting for their outcomes
  double objective_s = 0;
  double merge_s = 0;
  double improve_s = 0;                  // of total_s; nothing else here counts what trials do
  double total_s = 0;                    // of the loop, without the set-up of canvas and collage
  std::optional<double> last_tenth;      // covered in the last tenth of total_s, of the canvas; nothing: not known
  double setup_processor_s = 0;          // of this process, before the loop
  std::optional<StopReason> stopped_by;  // nothing: the run goes on

  double pruned_fraction() const {
    return docking_choices ? 1.0 - double(dockings_evaluated) / double(docking_choices) : 0.0;
  }
};

}  // namespace tessera
