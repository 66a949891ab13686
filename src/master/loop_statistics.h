// What a run counted and how long its stages took. Nothing is decided by it.
#pragma once

#include "core/base/processor_time.h"
#include "core/base/run_statistics.h"
#include "core/collage/loop_state.h"

namespace tessera::master {

class LoopStatistics {
 public:
  /// Of the greedy part of the run, what came before an interruption included; and the number of trials kept.
  RunStatistics filling;
  /// Of the trials of this call.
  RunStatistics improving;

  /// The set-up, which began with the constructor, has ended: the loop begins.
  void end_set_up() { set_up_processor_s_ = processor_time_s() - begin_processor_s_; }
  /// The run counted so much before it was interrupted.
  void go_on_after(const RunStatistics& earlier) { filling = earlier_ = earlier; }

  /// Of the run as a whole.
  RunStatistics of_run(const LoopState& state) const;
  /// Times, rounds and target samples of this call, which took `own_s`, trials included.
  RunStatistics of_this_call(double own_s) const;

 private:
  double begin_processor_s_ = processor_time_s();
  double set_up_processor_s_ = 0;
  RunStatistics earlier_;
};

}  // namespace tessera::master
