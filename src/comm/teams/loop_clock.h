// Measures the loop's time on rank 0, then gathers the times of all ranks.
#pragma once

#include "comm/communicator.h"
#include "core/base/run_statistics.h"
#include "core/ranks/rank_statistics.h"

namespace tessera::comm {

class LoopClock {
 public:
  /// The measurement begins with the constructor, just before the loop. The communicator must outlive the clock.
  explicit LoopClock(Communicator& ranks);

  /// Ends the measurement; `run` holds the loop's own times. Asks the workers for theirs; without workers the result is
  /// empty.
  RankStatistics stop(const RunStatistics& run);

 private:
  MasterTimes master_times(const RunStatistics& run) const;

  Communicator& ranks_;
  double waited_before_s_;
  double processor_before_s_;
  Traffic traffic_before_;
};

}  // namespace tessera::comm
