// The counters of a run, and the times of its stages. No decision depends on it.
#pragma once

#include "core/base/processor_time.h"
#include "core/base/run_statistics.h"
#include "core/collage/loop_state.h"

namespace tessera::master {

class LoopStatistics {
 public:
  /// Statistics of the greedy part of the run, with the part before an interruption; and the number of trials kept.
  RunStatistics filling;
  /// Statistics of the trials of this call.
  RunStatistics improving;

  /// Notes that the set-up, which began with the constructor, has ended: the loop begins.
  void end_set_up() { set_up_processor_s_ = processor_time_s() - begin_processor_s_; }
  /// Sets what the run counted before it was interrupted.
  void go_on_after(const RunStatistics& earlier) { filling = earlier_ = earlier; }

  /// Statistics of the whole run.
  RunStatistics of_run(const LoopState& state) const;
  /// Times, rounds and target samples of this call, trials included. The call took `own_s` seconds.
  RunStatistics of_this_call(double own_s) const;

 private:
  double begin_processor_s_ = processor_time_s();
  double set_up_processor_s_ = 0;
  RunStatistics earlier_;
};

}  // namespace tessera::master
