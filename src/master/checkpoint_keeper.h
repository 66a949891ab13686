// Keeps the loop's state for a restart, and decides when. The caller injects it, so that the loop knows neither files nor
// clocks.
#pragma once

#include "core/collage/checkpoint_state.h"
#include "core/collage/loop_state.h"

namespace tessera::master {

class CheckpointKeeper {
 public:
  virtual ~CheckpointKeeper() = default;
  /// Whether the loop shall keep its state now. The loop asks after every round and every trial. `phase`: of the next one.
  virtual bool due(LoopPhase phase) = 0;
  /// Keeps the state. Does not throw where that fails: the loop goes on without a checkpoint.
  virtual void keep(const CheckpointState& state) = 0;
};

}  // namespace tessera::master
