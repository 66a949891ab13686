// The position of a collage's loop between two rounds or trials. Checkpoints keep it.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/run_statistics.h"
#include "core/collage/placement.h"

namespace tessera {

enum class LoopPhase : std::uint8_t {
  filling,    // pieces are placed one by one, until none fits (paper, Fig. 15)
  trying,     // the region is full, and trials improve it
  replacing,  // batches of trials replace single pieces, while the pieces round them make room
};

/// Decides how the loop goes on, together with the job, the library and the collage itself.
struct LoopState {
  std::uint32_t region = 0;  // of the canvas, being filled
  LoopPhase phase = LoopPhase::filling;
  std::vector<Placement> moving = {};  // while replacing: all pieces, the given ones first; otherwise empty
  std::uint64_t replaced = 0;          // replacement trials of this region
  std::uint64_t trials = 0;            // trials of improving in all regions; their random numbers follow from it
  double improve_s = 0;                // time that improving took
  double run_s = 0;                    // time that the run took, improving included

  void begin_region(std::uint32_t begun) {
    region = begun;
    phase = LoopPhase::filling;
    moving.clear();
    replaced = 0;
  }
  /// Replaces pieces of these placements from now on. If there are none, the phase is `trying` again.
  void replace_in(std::vector<Placement> placements) {
    moving = std::move(placements);
    phase = moving.empty() ? LoopPhase::trying : LoopPhase::replacing;
  }

  friend bool operator==(const LoopState&, const LoopState&) = default;
};

/// Copies the trials and times of this state into the statistics of the run.
inline void copy_to_statistics(RunStatistics& statistics, const LoopState& state) {
  statistics.trials = state.trials;
  statistics.improve_s = state.improve_s;
  statistics.total_s = state.run_s;
}

}  // namespace tessera
