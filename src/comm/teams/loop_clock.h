// Measures the loop's time on rank 0, then gathers that of all ranks.
#pragma once

#include "comm/communicator.h"
#include "core/base/run_statistics.h"
#include "core/ranks/rank_statistics.h"

namespace tessera::comm {

class LoopClock {
 public:
  /// The loop is about to begin; the communicator outlives the clock.
  explicit LoopClock(Communicator& ranks);

  /// The loop is over, and these are its own times. Asks the workers for theirs; without workers the result is empty.
  RankStatistics stop(const RunStatistics& run);

 private:
  MasterTimes master_times(const RunStatistics& run) const;

  Communicator& ranks_;
  double waited_before_s_;
  double processor_before_s_;
  Traffic traffic_before_;
};

}  // namespace tessera::comm
