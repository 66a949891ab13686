// Where the loop's state is kept for a restart, and when: injected, so that the loop knows neither files nor clocks.
#pragma once

#include "core/collage/checkpoint_state.h"

namespace tessera::master {

class CheckpointKeeper {
 public:
  virtual ~CheckpointKeeper() = default;
  /// Asked after every round and trial, whether the state is to be kept now.
  virtual bool due() = 0;
  /// Does not throw where the state cannot be kept: the loop goes on without.
  virtual void keep(const CheckpointState& state) = 0;
};

}  // namespace tessera::master
